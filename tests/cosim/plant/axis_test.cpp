#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cosim/plant/counts_per_rev.hpp"
#include "cosim/plant/incremental_encoder.hpp"
#include "tests/cosim/support/driven_motor.hpp"

namespace armature::cosim {
namespace {

// One axis of the plant: drive, motor, encoder.
struct Axis {
  explicit Axis(const AxisSpec& spec = {}) : motor{spec}, encoder{counts_per_rev(spec)} {}

  void step(Cycles now) {
    motor.step();
    encoder.move(now, kPlantStep, motor.position());
  }

  test::DrivenMotor motor;
  IncrementalEncoder encoder;
};

// Pulses of constant rate on an axis, stepped as the plant does it; calls `each_cycle` after the events of every cycle.
template <class EachCycle>
void drive(Axis& axis, std::int64_t cycles, std::int64_t cycles_per_pulse, EachCycle each_cycle) {
  axis.motor.on_pins(Cycles{0}, false, kDirForward, true);
  const std::int64_t half = cycles_per_pulse / 2;
  for (std::int64_t now = 1; now <= cycles; ++now) {
    if (now >= 100 && now % cycles_per_pulse == 0) axis.motor.on_pins(Cycles{now}, true, kDirForward, true);
    if (now >= 100 && now % cycles_per_pulse == half) axis.motor.on_pins(Cycles{now}, false, kDirForward, true);
    if (axis.encoder.next_edge() == Cycles{now}) axis.encoder.execute_edge();
    if (now % kPlantStep.value() == 0) axis.step(Cycles{now});
    each_cycle(now);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(Axis, ShowsTheMotionBetweenTwoStepsAtConstantSpeed) {
  Axis axis;
  Subcounts start{}, target{};
  std::int64_t from = 0;
  drive(axis, 1'000'000, 200, [&](std::int64_t now) {
    const std::int64_t step = kPlantStep.value();
    // At the grid cycle itself the previous motion has just ended.
    const std::int64_t scaled = start.value() * step + (target - start).value() * (now - from);
    const auto count = static_cast<std::int64_t>(
        std::floor(static_cast<double>(scaled) / static_cast<double>(step * kSubcountsPerCount) + 0.5));
    ASSERT_EQ(axis.encoder.count().value(), count) << "cycle " << now;
    if (now % step == 0) {
      start = target;
      target = axis.motor.position();
      from = now;
    }
  });
  EXPECT_GT(axis.encoder.count().value(), 1000);
}

TEST(Axis, FollowsFourMillionPulsesPerSecondWithOneCountPerPulse) {
  AxisSpec spec;
  spec.pulses_per_rev = 131'072;
  spec.encoder_lines = 32'768;
  spec.drive.max_torque_nm = 10.0;
  Axis axis{spec};
  std::int64_t last = 0, shortest = 1'000'000, before = 0;
  drive(axis, 4'000'000, 12, [&](std::int64_t now) {  // 12 cycles a pulse: 4.17 Mpps, the tightest spacing of the logic
    const std::int64_t count = axis.encoder.count().value();
    if (count == before) return;
    ASSERT_EQ(count, before + 1);
    shortest = std::min(shortest, now - last);
    last = now;
    before = count;
  });
  EXPECT_EQ(shortest, 12);
  const double wn = 6.283185307179586 * spec.drive.natural_hz;
  EXPECT_NEAR(axis.motor.speed(), 50e6 / 12.0, 1.0);
  EXPECT_NEAR(axis.motor.following_error(), 2.0 / wn * 50e6 / 12.0, 20.0);
  EXPECT_FALSE(axis.motor.drive.violation());
}

TEST(Axis, ActsOnAPulseAtTheNextStep) {
  Axis axis;
  axis.motor.on_pins(Cycles{1}, false, kDirForward, true);
  axis.step(Cycles{250});
  axis.motor.on_pins(Cycles{251}, true, kDirForward, true);
  EXPECT_EQ(axis.motor.position().value(), 0);
  axis.step(Cycles{500});
  EXPECT_GT(axis.motor.position().value(), 0);
}

}  // namespace
}  // namespace armature::cosim
