// The seam between the motion loop and what gives it set-points, from both sides.
#include "controller/motion/set_point_source.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <variant>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/motion/count_logic_port.hpp"
#include "controller/motion/motion_loop.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "controller/robot/axis_units.hpp"
#include "tests/controller/support/model_logic.hpp"
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
  void run(SetPointSource& source, std::int64_t triggers) {
    logic.fit_drives(robot);
    logic.triggers_to_run = triggers;
    CountLogicPort port{logic};
    MotionLoop{robot, false, port, logic, channel, source, notes}.run();
  }

  RobotModel robot = test::paper_robot();
  test::ModelLogic logic;
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
    if (trigger == 40) logic.pins.drive_alarm = 1;
  };
  Turning source{0.0};
  run(source, 60);
  ASSERT_EQ(notes.events.size(), 1u);
  const Ticks fault = std::get<Faulted>(notes.events[0]).tick;
  EXPECT_EQ(source.cut_at, fault);
  EXPECT_EQ(source.given_up, static_cast<int>(notes.rows.size()) - static_cast<int>(fault.value()) - 1);
  EXPECT_EQ(notes.rows.back().rate, 0.0);
}

// As long as it turns, axis 1 jumps from 100 pulses in a tick to as many in the other direction after every 50 ticks.
class Reversing final : public SetPointSource {
 public:
  Reversing(double step_rad, Ticks until) : step_rad_{step_rad}, until_{until} {}
  const SetPoint& advance(Ticks tick) noexcept override {
    if (tick < until_) set_point_.position[0] += Radians{tick.value() / 50 % 2 == 0 ? step_rad_ : -step_rad_};
    return set_point_;
  }
  void reset_to(const PerAxis<Radians>& position) noexcept override { set_point_ = {.position = position}; }
  void cut_short(Ticks) noexcept override {}
  void cancel(Ticks) noexcept override {}

 private:
  double step_rad_;
  Ticks until_;
};

TEST_F(SetPointSourceTest, PulsesThatDoNotFitInATickAfterAReversalAreSentAgain) {
  robot = test::fine_robot();
  robot.axes[0].dir_setup_cycles = robot.axes[0].dir_hold_cycles = 1'000;  // leaves a fifth of the tick
  Reversing source{100 * AxisUnits{robot.axes[0]}.rad_per_pulse(), Ticks{475}};
  run(source, 2'000);
  EXPECT_NE(logic.faults_read() & regs::pulse_train::kFaultResidualMask, 0u);
  EXPECT_TRUE(notes.events.empty());
  ASSERT_GT(notes.rows.size(), 1'900u);
  EXPECT_EQ(notes.rows.back().reference_pulses[0], Pulses{5'000 - 2'500});
  EXPECT_EQ(logic.emitted(0), 5'000 - 2'500);
  EXPECT_EQ(notes.rows.back().correction[0], Pulses{0});  // no loss in the drive
  EXPECT_EQ(logic.count(0), 5'000 - 2'500);
}

}  // namespace
}  // namespace armature
