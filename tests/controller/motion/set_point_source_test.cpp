// The seam between the motion loop and what gives it set-points, from both sides.
#include "controller/motion/set_point_source.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <variant>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/motion/count_logic_port.hpp"
#include "controller/motion/motion_loop.hpp"
#include "controller/robot/axis_units.hpp"
#include "tests/controller/support/fake_logic.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

class Notes final : public ControllerObserver {
 public:
  void on_tick(const Telemetry& telemetry) noexcept override { rows.push_back(telemetry); }
  void on_event(const Event& event) noexcept override { events.push_back(event); }
  std::vector<Telemetry> rows;
  std::vector<Event> events;
};

// Turns axis 1 by one and a half pulses in every tick: a source that has never heard of plans.
class Turning final : public SetPointSource {
 public:
  explicit Turning(double step_rad) : step_rad_{step_rad} {}
  const SetPoint& advance(Ticks) noexcept override {
    set_point_.position[0] += Radians{step_rad_};
    set_point_.state = MotionState::kMoving;
    set_point_.rate = 1.0;
    return set_point_;
  }
  void reset_to(const PerAxis<Radians>& position) noexcept override { set_point_ = {.position = position}; }
  void cut_short(Ticks tick) noexcept override { cut_at = tick; }
  void cancel(Ticks) noexcept override {
    ++given_up;
    set_point_.rate = 0.0;
  }

  Ticks cut_at{};
  int given_up = 0;

 private:
  double step_rad_;
};

struct SetPointSourceTest : testing::Test {
  SetPointSourceTest() {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const AxisModel& from = robot.axes[axis];
      logic.drives[axis].counts_per_pulse = static_cast<double>(from.counts_per_rev) / from.pulses_per_rev;
    }
  }
  void run(SetPointSource& source, std::int64_t triggers) {
    logic.triggers_to_run = triggers;
    CountLogicPort port{logic};
    MotionLoop{robot, false, port, logic, channel, source, notes}.run();
  }

  RobotModel robot = test::paper_robot();
  test::FakeLogic logic;
  LoopChannel channel;
  Notes notes;
};

TEST_F(SetPointSourceTest, TheMotionLoopFollowsAnySource) {
  Turning source{1.5 * AxisUnits{robot.axes[0]}.rad_per_pulse()};
  run(source, 1'002);
  ASSERT_GT(notes.rows.size(), 1'000u);
  EXPECT_EQ(notes.rows[999].reference_pulses[0], Pulses{1'500});
  EXPECT_EQ(notes.rows[999].state, MotionState::kMoving);
  EXPECT_EQ(notes.rows[999].rate, 1.0);
  EXPECT_EQ(source.given_up, 0);
}

TEST_F(SetPointSourceTest, AFaultCutsItShortOnceAndGivesItUpInEveryTickAfterThat) {
  logic.on_trigger = [&](std::int64_t trigger) {
    if (trigger == 40) logic.alarm = 1;
  };
  Turning source{0.0};
  run(source, 60);
  ASSERT_EQ(notes.events.size(), 1u);
  const Ticks fault = std::get<Faulted>(notes.events[0]).tick;
  EXPECT_EQ(source.cut_at, fault);
  EXPECT_EQ(source.given_up, static_cast<int>(notes.rows.size()) - static_cast<int>(fault.value()) - 1);
  EXPECT_EQ(notes.rows.back().rate, 0.0);
}

}  // namespace
}  // namespace armature
