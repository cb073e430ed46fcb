// The steps of a tick for all axes at once, against the steps and pulses one by one.
#include "cosim/plant/ticks/tick_steps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "cosim/plant/clock.hpp"
#include "cosim/plant/counts_per_rev.hpp"
#include "cosim/plant/independent_axes.hpp"
#include "cosim/plant/position_loop.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

using armature::test::SplitMix;

constexpr std::uint64_t kTickStepsSeed = 7;

double between(SplitMix& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random.below(1'000'001)) * 1e-6;
}

RobotSpec random_robot(SplitMix& random) {
  RobotSpec robot;
  const bool plain_gears = random.below(2) == 0;
  for (AxisSpec& axis : robot.axes) {
    if (!plain_gears && random.below(2) == 0) axis.encoder_lines = static_cast<std::int32_t>(1 + random.below(4000));
    if (random.below(3) == 0) axis.drive.natural_hz = between(random, 5.0, 200.0);
  }
  return robot;
}

struct SixMotors {
  explicit SixMotors(const RobotSpec& robot) : mechanics{robot} {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      drives.emplace_back(axis, robot.axes[axis]);
      loops.emplace_back(robot.axes[axis].drive, static_cast<double>(counts_per_rev(robot.axes[axis])));
      Shaft shaft;
      drives[axis].on_pins(Cycles{0}, false, false, true, shaft);
      drives[axis].observe(shaft);
    }
  }

  IndependentAxes mechanics;
  std::vector<ServoDrive> drives;
  std::vector<PositionLoop> loops;
};

// Some axes at rest, some that follow, some that a limit stops; or all about to come to rest.
Shafts random_shafts(SplitMix& random) {
  Shafts shafts;
  const bool settle = random.below(8) == 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::uint32_t kind = random.below(4);
    if (kind == 0) continue;
    const double size = settle ? 1e-6 : kind == 1 ? 1e-5 : kind == 2 ? 20.0 : 20'000.0;
    shafts.set(axis,
               {.error = between(random, -size, size), .speed = between(random, -size, size) * (settle ? 1e-3 : 1e-2)});
  }
  return shafts;
}

TickPulses random_tick(SplitMix& random) {
  const Cycles begins{static_cast<std::int64_t>(1 + random.below(100'000))};
  TickPulses tick{.begins = begins, .ends = begins + Cycles{2500}};
  const std::uint32_t most = 1 + random.below(random.below(2) == 0 ? 10u : 200u);
  const std::uint32_t idle_axes = random.below(6) == 0 ? 11 : 4;  // of 12
  for (AxisPulses& pulses : tick.axes) {
    if (random.below(12) < idle_axes) continue;
    const auto blocked = static_cast<std::int32_t>(random.below(3) == 0 ? random.below(100) : 0u);
    const auto count = static_cast<std::int32_t>(random.below(most + 1));
    pulses = {
        .count = random.below(2) == 0 ? -count : count, .first = begins + Cycles{blocked}, .window = 2500 - blocked};
  }
  return tick;
}

class OneByOne {
 public:
  OneByOne(const SixMotors& bench, const TickPulses& tick, const Shafts& shafts, bool moves) : tick_{tick} {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      gears.push_back(bench.drives[axis].gear());
      this->shafts.push_back(shafts[axis]);
    }
    for (Cycles now = grid_from(tick.begins); now < tick.ends; now += kPlantStep) {
      const bool before = take(now - Cycles{1}), with = take(now);
      if (moves || before) {
        for (std::size_t axis = 0; axis < kAxes; ++axis) bench.loops[axis].step(this->shafts[axis]);
        show(now);
        moves = std::ranges::any_of(this->shafts, [](const Shaft& shaft) { return !shaft.at_rest(); });
      } else {
        moves = with;
      }
    }
    take(tick.ends - Cycles{1});
  }

  struct Step {
    Cycles began{};
    PerAxis<Subcounts> positions{};
    PerAxis<double> errors{};
  };
  std::vector<Step> steps;
  std::vector<Shaft> shafts;
  std::vector<ElectronicGear> gears;

 private:
  bool take(Cycles until) {
    bool any = false;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const AxisPulses& pulses = tick_.axes[axis];
      const int direction = pulses.count < 0 ? -1 : +1;
      for (; taken_[axis] < pulses.rises_until(until); ++taken_[axis]) {
        gears[axis].pulses(direction);
        shafts[axis].error -= direction * gears[axis].counts_per_pulse();
        any = true;
      }
    }
    return any;
  }
  void show(Cycles now) {
    Step& step = steps.emplace_back();
    step.began = now;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      step.errors[axis] = shafts[axis].error;
      step.positions[axis] = ServoDrive::position_at(gears[axis], shafts[axis].error);
    }
  }

  const TickPulses& tick_;
  PerAxis<std::int32_t> taken_{};
};

TEST(TickSteps, AreTheStepsAndPulsesOneByOne) {
  SplitMix random{kTickStepsSeed};
  TickSteps got;
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kTickStepsSeed << ", tick " << i);
    SixMotors bench{random_robot(random)};
    Shafts shafts = random.below(8) == 0 ? Shafts{} : random_shafts(random);
    const TickPulses tick = random_tick(random);
    std::uint8_t moving = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) set_bit(moving, axis, !shafts[axis].at_rest());
    const OneByOne wanted{bench, tick, shafts, moving != 0};
    got.run(tick, bench.drives, moving, bench.mechanics, shafts);
    ASSERT_EQ(got.size(), wanted.steps.size());
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      ASSERT_EQ(shafts[axis].error, wanted.shafts[axis].error) << "axis " << axis;
      ASSERT_EQ(shafts[axis].speed, wanted.shafts[axis].speed) << "axis " << axis;
      double smallest = 1e300, largest = 0.0;
      for (std::size_t step = 0; step < got.size(); ++step) {
        ASSERT_EQ(got.began(step), wanted.steps[step].began);
        ASSERT_EQ(got.position(step, axis), wanted.steps[step].positions[axis]) << "step " << step << ", axis " << axis;
        smallest = std::min(smallest, std::fabs(wanted.steps[step].errors[axis]));
        largest = std::max(largest, std::fabs(wanted.steps[step].errors[axis]));
      }
      if (got.size() == 0) continue;
      ASSERT_EQ(got.extremes().smallest_error[axis], smallest);
      ASSERT_EQ(got.extremes().largest_error[axis], largest);
    }
  }
}

TEST(TickSteps, SeveralPulsesAtOnceAreRoundedAsOneByOne) {
  SplitMix random{kTickStepsSeed + 1};
  for (int i = 0; i < 200'000; ++i) {
    const double size = std::ldexp(1.0, static_cast<int>(random.below(28)) - 8);
    const double error = between(random, -size, size) + std::ldexp(1.0, -40) * static_cast<double>(random.below(4096));
    const double step = random.below(4) == 0 ? 0.8192 : 1.0;
    const int count = static_cast<int>(random.below(21));
    double wanted = error;
    for (int pulse = 0; pulse < count; ++pulse) wanted -= step;
    ASSERT_EQ(less_pulses(error, step, count), wanted) << error << " less " << count << " times " << step;
    ASSERT_EQ(less_pulses(-error, -step, count), -wanted);
  }
}

}  // namespace
}  // namespace armature::cosim
