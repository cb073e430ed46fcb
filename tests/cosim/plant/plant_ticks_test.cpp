// Whole ticks of the plant, against a plant whose edges are all computed: where a tick is whole nothing but the encoder
// lines changes in it, and index and counts are those of the edges.
#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "cosim/plant/plant.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

using armature::test::SplitMix;

constexpr std::uint64_t kPlantTicksSeed = 3;
constexpr Cycles kTick{2500};

RobotSpec robot_with_events(SplitMix& random) {
  RobotSpec robot;
  for (AxisSpec& axis : robot.axes) {
    axis.gear_ratio = 1.0;
    axis.encoder_lines = random.below(2) == 0 ? 5 : 40;
    axis.pulses_per_rev = 4 * axis.encoder_lines;
    axis.drive.max_speed_rpm = 1e7;
    axis.drive.max_torque_nm = 1e6;
    axis.drive.natural_hz = 9000.0;  // so fast that the axes stay in position
    if (random.below(2) == 0) axis.home_switch_deg = {{-30.0, 500.0}};
    if (random.below(2) == 0) axis.limit_switch_deg = {{-700.0, 700.0}};
  }
  return robot;
}

// One tick after the other from cycle 2501 on; a reversal blocks an axis for 60 cycles.
std::vector<TickPulses> random_ticks(SplitMix& random, int number) {
  std::vector<TickPulses> ticks;
  PerAxis<int> direction;
  direction.fill(-1);
  for (int i = 0; i < number; ++i) {
    TickPulses& tick = ticks.emplace_back();
    tick.begins = Cycles{1} + Cycles{kTick.value() * (i + 1)};
    tick.ends = tick.begins + kTick;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const int wanted = random.below(12) == 0 ? -direction[axis] : direction[axis];
      const auto count = static_cast<std::int32_t>(random.below(5));
      if (count == 0) continue;
      const std::int32_t blocked = wanted == direction[axis] ? 0 : 60;
      direction[axis] = wanted;
      const Cycles first = tick.begins + Cycles{blocked};
      tick.axes[axis] = {.count = wanted * count, .first = first, .window = 2500 - blocked, .fell = {}, .turned = {}};
      tick.axes[axis].turned = blocked == 0 ? Cycles{} : first - Cycles{30};
    }
  }
  return ticks;
}

// Computes every edge.
class EdgePlant {
 public:
  EdgePlant(const RobotSpec& robot, const std::vector<TickPulses>& ticks) : plant{robot}, ticks_{ticks} {
    out_.servo_on = kAllAxes;
    plant.on_outputs(Cycles{0}, out_);
  }

  void run(Cycles until) {
    for (; now_ <= until; now_ += Cycles{1}) {
      const SocOutputs before = out_;
      for (std::size_t axis = 0; axis < kAxes; ++axis) show_pulses(axis);
      if (!(out_ == before)) plant.on_outputs(now_, out_);
      if (plant.next_event() <= now_) plant.advance(now_);
      const SocInputs& in = plant.inputs();
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (has_bit(in.enc_z & ~seen_.enc_z, axis)) index[axis].push_back(plant.motor_counts(axis));
      }
      other_changes += in.home != seen_.home || in.limit_neg != seen_.limit_neg || in.limit_pos != seen_.limit_pos ||
                       in.in_position != seen_.in_position || in.drive_alarm != seen_.drive_alarm;
      seen_ = in;
    }
  }

  Plant plant;
  PerAxis<std::vector<Counts>> index{};
  int other_changes = 0;

 private:
  // After the edge now_.
  void show_pulses(std::size_t axis) {
    const std::int64_t tick = (now_.value() - 2) / kTick.value() - 1;
    if (tick < 0 || tick >= static_cast<std::int64_t>(ticks_.size())) return;
    const AxisPulses& pulses = ticks_[static_cast<std::size_t>(tick)].axes[axis];
    const std::int64_t elapsed = (now_ - pulses.first).value();
    if (pulses.count == 0) return;
    if (now_ >= pulses.turned) set_bit(out_.dir, axis, pulses.count > 0);
    if (elapsed > 0) set_bit(out_.step, axis, elapsed * 2 * pulses.pulses() / pulses.window % 2 == 1);
  }

  const std::vector<TickPulses>& ticks_;
  SocOutputs out_;
  SocInputs seen_;
  Cycles now_{1};
};

TEST(PlantTicks, ShowTheIndexAndTheCountsOfTheirEdgesAndNothingElse) {
  SplitMix random{kPlantTicksSeed};
  int whole_ticks = 0, indexes = 0, refused = 0;
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kPlantTicksSeed << ", draw " << i);
    const RobotSpec robot = robot_with_events(random);
    const std::vector<TickPulses> ticks = random_ticks(random, 25);
    const std::vector<TickPulses> none;
    EdgePlant edges{robot, ticks}, start{robot, none};
    Plant& whole = start.plant;
    start.run(ticks.front().begins - Cycles{1});
    edges.run(grid_from(ticks.front().begins) - Cycles{1});
    for (std::size_t tick = 0; tick + 1 < ticks.size(); ++tick) {
      const bool is_whole = whole.begin_tick(ticks[tick], Cycles{8});
      for (auto& index : edges.index) index.clear();
      edges.other_changes = 0;
      edges.run(ticks[tick].ends - Cycles{2});
      const PerAxis<Counts> counts = make_per_axis([&](std::size_t axis) { return edges.plant.motor_counts(axis); });
      edges.run(grid_from(ticks[tick].ends) - Cycles{1});
      if (!is_whole) {
        ++refused;
        break;
      }
      ++whole_ticks;
      ASSERT_EQ(edges.other_changes, 0) << "tick " << tick;
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const std::optional<Counts>& index = whole.index_in_tick()[axis];
        ASSERT_EQ(whole.motor_counts(axis), counts[axis]) << "tick " << tick << ", axis " << axis;
        ASSERT_EQ(edges.index[axis].size(), index ? 1u : 0u) << "tick " << tick << ", axis " << axis;
        if (index) {
          ++indexes;
          ASSERT_EQ(edges.index[axis].front(), *index) << "tick " << tick << ", axis " << axis;
        }
      }
    }
  }
  EXPECT_GT(whole_ticks, 200);
  EXPECT_GT(indexes, 30);
  EXPECT_GT(refused, 3);
}

}  // namespace
}  // namespace armature::cosim
