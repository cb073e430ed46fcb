#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "cosim/plant/plant.hpp"

namespace armature::cosim {
namespace {

constexpr std::uint8_t kAllAxes = 0x3F;

constexpr std::int64_t kFirstPulse = 1000;
constexpr std::int64_t period(std::int64_t axis) {
  return 130 + 10 * axis;
}
constexpr std::int64_t pulses_before(std::int64_t cycle, std::int64_t axis) {
  return (cycle - kFirstPulse + period(axis) - 1) / period(axis);
}

// Six pulse generators of different rates and directions: axis i has a pulse every 130 + 10 i cycles, odd axes
// backwards.
SocOutputs generate(std::int64_t now, std::int64_t last_pulse) {
  SocOutputs out;
  out.servo_on = kAllAxes;
  out.dir = 0b010101;
  for (std::int64_t axis = 0; axis < 6; ++axis) {
    if (now < kFirstPulse) continue;
    const std::int64_t phase = (now - kFirstPulse) % period(axis);
    if (now - phase < last_pulse && phase < period(axis) / 2) {
      out.step = static_cast<std::uint8_t>(out.step | (1 << axis));
    }
  }
  return out;
}

// Runs as the kernel does; `each_cycle` sees the plant after the events of every cycle.
template <class EachCycle>
void run(Plant& plant, std::int64_t cycles, std::int64_t last_pulse, EachCycle each_cycle) {
  SocOutputs seen;
  for (std::int64_t now = 1; now <= cycles; ++now) {
    const SocOutputs out = generate(now, last_pulse);
    if (!(out == seen)) plant.on_outputs(Cycles{now}, out);
    seen = out;
    if (plant.next_event() <= Cycles{now}) plant.advance(Cycles{now});
    each_cycle(now);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(Plant, StartsAtRestWithTheIndexHigh) {
  const Plant plant{RobotSpec{}};
  SocInputs expected;
  expected.enc_z = kAllAxes;
  EXPECT_EQ(plant.inputs(), expected);
  EXPECT_EQ(plant.next_event(), kNever);
}

TEST(Plant, MovesSixMotorsByTheirPulsesAndShowsEveryCountOnItsLines) {
  Plant plant{RobotSpec{}};
  // A decoder of its own: Vo 2021, Table 1.
  PerAxis<std::int64_t> decoded{};
  SocInputs before = plant.inputs();
  run(plant, 12'000'000, 200'000, [&](std::int64_t now) {
    const SocInputs& pins = plant.inputs();
    if (pins == before) return;
    for (unsigned axis = 0; axis < 6; ++axis) {
      const bool a = (pins.enc_a >> axis) & 1, b = (pins.enc_b >> axis) & 1;
      const bool a_prev = (before.enc_a >> axis) & 1, b_prev = (before.enc_b >> axis) & 1;
      ASSERT_FALSE(a != a_prev && b != b_prev) << "illegal transition, axis " << axis << ", cycle " << now;
      if (a != a_prev || b != b_prev) decoded[axis] += (a != b_prev) ? 1 : -1;
      ASSERT_EQ(plant.motor_counts(axis).value(), decoded[axis]);
    }
    before = pins;
  });
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::int64_t pulses = pulses_before(200'000, static_cast<std::int64_t>(axis));
    const std::int64_t signed_pulses = axis % 2 == 0 ? pulses : -pulses;
    EXPECT_EQ(plant.drive_pulses(axis).value(), signed_pulses);
    EXPECT_EQ(plant.motor_counts(axis).value(), signed_pulses);
    EXPECT_NEAR(plant.motor_deg(axis, Cycles{12'000'000}), static_cast<double>(signed_pulses) * 7.2e-4, 1e-9);
    EXPECT_EQ(plant.following_error(axis), 0.0);
  }
  EXPECT_FALSE(plant.violation());
  EXPECT_EQ(plant.inputs().in_position, kAllAxes);
  EXPECT_EQ(plant.inputs().drive_alarm, 0);
  EXPECT_EQ(plant.next_event(), kNever) << "motors at rest cost nothing";
}

TEST(Plant, DoesNotDependOnCallsWithoutAChange) {
  Plant once{RobotSpec{}}, often{RobotSpec{}};
  std::vector<SocInputs> shown;
  run(once, 300'000, 200'000, [&](std::int64_t) { shown.push_back(once.inputs()); });
  for (std::int64_t now = 1; now <= 300'000; ++now) {
    often.on_outputs(Cycles{now}, generate(now, 200'000));
    often.advance(Cycles{now});
    ASSERT_EQ(often.inputs(), shown[static_cast<std::size_t>(now - 1)]) << "cycle " << now;
  }
}

TEST(Plant, TouchesOnlyTheAxisWhosePinsChange) {
  Plant plant{RobotSpec{}};
  SocOutputs out;
  out.servo_on = 0b001000;
  plant.on_outputs(Cycles{10}, out);
  EXPECT_EQ(plant.next_event(), Cycles{250});
  plant.advance(Cycles{250});
  EXPECT_EQ(plant.inputs().in_position, 0b001000);
  EXPECT_EQ(plant.next_event(), kNever);

  out.dir = 0b001000;
  plant.on_outputs(Cycles{300}, out);
  out.step = 0b001000;
  plant.on_outputs(Cycles{500}, out);
  EXPECT_EQ(plant.next_event(), Cycles{750}) << "a step never begins in the cycle of its cause";
  for (int i = 0; i < 100'000 && plant.next_event() != kNever; ++i) plant.advance(plant.next_event());
  for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_EQ(plant.motor_counts(axis).value(), axis == 3 ? 1 : 0);
  EXPECT_EQ(plant.inputs().enc_a, 0b001000);
  EXPECT_EQ(plant.inputs().enc_b, 0);
  EXPECT_EQ(plant.inputs().enc_z, 0b110111);
}

TEST(Plant, ReportsTheFirstViolationWithItsAxis) {
  Plant plant{RobotSpec{}};
  SocOutputs out;
  out.servo_on = kAllAxes;
  plant.on_outputs(Cycles{10}, out);
  out.step = 0b100000;
  plant.on_outputs(Cycles{100}, out);
  out.step = 0b000001;
  plant.on_outputs(Cycles{104}, out);  // axis 6 low again after 4 cycles
  out.step = 0;
  plant.on_outputs(Cycles{105}, out);  // axis 1 after 1 cycle
  ASSERT_TRUE(plant.violation());
  EXPECT_EQ(plant.violation()->axis, 5u);
  EXPECT_EQ(plant.violation()->cycle, Cycles{104});
}

TEST(Plant, LosesThePulsesThatTheFaultScriptNames) {
  Plant plant{RobotSpec{}};
  plant.drop_pulses(2, 500);
  run(plant, 400'000, 200'000, [](std::int64_t) {});
  EXPECT_EQ(plant.dropped_pulses(2).value(), 500);
  EXPECT_EQ(plant.dropped_pulses(1).value(), 0);
  EXPECT_EQ(plant.drive_pulses(2).value(), pulses_before(200'000, 2) - 500);
}

TEST(Plant, AMotorThatIsBlockedStandsUntilNothingBlocksIt) {
  Plant plant{RobotSpec{}};
  plant.block(2);
  plant.block(2);
  run(plant, 100'000, 100'000, [&](std::int64_t) { ASSERT_EQ(plant.motor_counts(2), Counts{0}); });
  EXPECT_NE(plant.motor_counts(1), Counts{0});
  EXPECT_GT(std::fabs(plant.following_error(2)), 100.0);
  plant.unblock(2);
  for (std::int64_t now = 100'001; now < 120'000; ++now) {
    if (plant.next_event() <= Cycles{now}) plant.advance(Cycles{now});
  }
  EXPECT_EQ(plant.motor_counts(2), Counts{0});
  plant.unblock(2);
  for (std::int64_t now = 120'000; now < 400'000; ++now) {
    if (plant.next_event() <= Cycles{now}) plant.advance(Cycles{now});
  }
  EXPECT_NE(plant.motor_counts(2), Counts{0});
}

TEST(Plant, ShowsTheAlarmOfADriveWithAFaultAtOnce) {
  Plant plant{RobotSpec{}};
  plant.on_outputs(Cycles{1}, {.servo_on = kAllAxes});
  plant.trip_drive(4, Cycles{2});
  EXPECT_EQ(plant.inputs().drive_alarm, 0b010000);
  for (std::int64_t now = 2; now < 1000; ++now) {
    if (plant.next_event() <= Cycles{now}) plant.advance(Cycles{now});
  }
  plant.repair_drive(4);
  EXPECT_EQ(plant.inputs().drive_alarm, 0b010000);
  plant.on_outputs(Cycles{1000}, {});
  for (std::int64_t now = 1000; now < 2000; ++now) {
    if (plant.next_event() <= Cycles{now}) plant.advance(Cycles{now});
  }
  EXPECT_EQ(plant.inputs().drive_alarm, 0);
}

TEST(Plant, RefusesToSkipAnEvent) {
  Plant plant{RobotSpec{}};
  SocOutputs out;
  out.servo_on = 1;
  plant.on_outputs(Cycles{10}, out);
  plant.advance(Cycles{249});
  EXPECT_THROW(plant.advance(Cycles{251}), std::logic_error);
}

TEST(Plant, GivesThePositionOfAMotorAsAJointAngle) {
  RobotSpec robot;
  robot.axes[0].gear_ratio = -50.0;
  Plant plant{robot};
  constexpr std::int64_t kEnd = 1'000'000;
  run(plant, kEnd, kEnd, [](std::int64_t) {});
  // 360 degrees / (50 x 10000 counts).
  EXPECT_NEAR(plant.motor_deg(0, Cycles{kEnd}), -7.2e-4 * static_cast<double>(plant.motor_counts(0).value()), 7.2e-4);
  EXPECT_LT(plant.motor_deg(0, Cycles{kEnd}), -1.0);
}

TEST(Plant, StartsAtTheNearestCountOfTheGivenAngles) {
  RobotSpec robot;
  robot.axes[1].gear_ratio = -50.0;
  // 360 degrees / (50 x 10000 counts) = 7.2e-4 degrees for a count.
  const Plant plant{robot, std::nullopt, {10.0, 10.0, -0.00215, 7.2, 0.0, 0.0}};
  EXPECT_EQ(plant.motor_counts(0).value(), 13889);
  EXPECT_EQ(plant.motor_counts(1).value(), -13889);
  EXPECT_EQ(plant.motor_counts(2).value(), -3);
  EXPECT_EQ(plant.motor_counts(3).value(), 10000) << "one turn of the motor";
  EXPECT_NEAR(plant.motor_deg(1, Cycles{0}), 10.0, 3.6e-4);
  // 13889 mod 4 = 1, -13889 mod 4 = 3, -3 mod 4 = 1.
  EXPECT_EQ(plant.inputs().enc_a, 0b000101);
  EXPECT_EQ(plant.inputs().enc_b, 0b000010);
  EXPECT_EQ(plant.inputs().enc_z, 0b111000);
  EXPECT_EQ(plant.next_event(), kNever);
}

TEST(Plant, MovesFromItsStartAndKeepsItWhenTheServoIsSwitchedOn) {
  RobotSpec robot;
  Plant plant{robot, std::nullopt, {10.0, -10.0}};
  run(plant, 4'000'000, 200'000, [](std::int64_t) {});
  EXPECT_EQ(plant.motor_counts(0).value(), 13889 + pulses_before(200'000, 0));
  EXPECT_EQ(plant.motor_counts(1).value(), -13889 - pulses_before(200'000, 1));
  EXPECT_EQ(plant.drive_pulses(0).value(), pulses_before(200'000, 0));
}

// The joint moves from -1.44 degrees through 0, in steps of a count, and back. A count is 7.2e-4 degrees.
TEST(Plant, ShowsItsSwitchesWhereTheJointIsInTheirRanges) {
  RobotSpec robot;
  for (const double gear : {50.0, -50.0}) {
    robot.axes[0].gear_ratio = gear;
    robot.axes[0].home_switch_deg = {-0.3604, 0.3604};   // 500.6 counts
    robot.axes[0].limit_switch_deg = {-1.0804, 1.0804};  // 1500.6 counts
    Plant plant{robot, std::nullopt, {-1.44}};
    EXPECT_EQ(plant.inputs().limit_neg, 1);
    bool seen_home = false, seen_limit = false;
    SocOutputs out;
    for (std::int64_t now = 1; now <= 1'800'000; ++now) {
      const SocOutputs before = out;
      const std::int64_t turn = now % 900'000;  // turns round half way, without pulses around it
      out.servo_on = 1;
      out.dir = (now < 900'000) == (gear > 0) ? 1 : 0;
      out.step = turn > 1000 && turn < 899'000 && now % 200 < 100 ? 1 : 0;
      if (!(out == before)) plant.on_outputs(Cycles{now}, out);
      if (plant.next_event() <= Cycles{now}) plant.advance(Cycles{now});
      const std::int64_t place = plant.motor_counts(0).value() * (gear > 0 ? 1 : -1);
      ASSERT_EQ(plant.inputs().home, std::abs(place) <= 500 ? 1 : 0) << place;
      ASSERT_EQ(plant.inputs().limit_neg, place <= -1501 ? 1 : 0) << place;
      ASSERT_EQ(plant.inputs().limit_pos, place >= 1501 ? 1 : 0) << place;
      seen_home = seen_home || plant.inputs().home != 0;
      seen_limit = seen_limit || plant.inputs().limit_pos != 0;
    }
    EXPECT_TRUE(seen_home);
    EXPECT_TRUE(seen_limit);
    EXPECT_FALSE(plant.violation());
  }
}

TEST(Plant, AnAxisWithoutSwitchesShowsNone) {
  const Plant plant{RobotSpec{}, std::nullopt, {-400.0, 400.0, 0.0}};
  EXPECT_EQ(plant.inputs().home | plant.inputs().limit_neg | plant.inputs().limit_pos, 0);
}

// A shaft that turns the next one with it.
class CoupledShafts final : public Mechanics {
 public:
  std::uint8_t step(std::uint8_t axes, const MotorDemands& demands, Shafts& shafts) override {
    controlled = has_bit(demands.controlled, 0);
    shafts.error[0] = 0.0;  // on its reference
    shafts.error[1] = demands.reference[0];
    return axes | 0b11;
  }
  void block(std::size_t, bool) override {}
  bool controlled = false;
};

TEST(Plant, MechanicsMayMoveAShaftWhoseDriveDemandsNothing) {
  auto owned = std::make_unique<CoupledShafts>();
  const CoupledShafts& mechanics = *owned;
  Plant plant{RobotSpec{}, std::move(owned)};
  std::int64_t now = 0;
  const auto until = [&](std::int64_t end) {
    for (; now < end; ++now) {
      if (plant.next_event() <= Cycles{now}) plant.advance(Cycles{now});
    }
  };
  SocOutputs out;
  out.servo_on = 0b1;
  out.dir = 0b1;
  plant.on_outputs(Cycles{0}, out);
  for (int pulse = 0; pulse < 3; ++pulse) {
    until(now + 1000);
    out.step = 1;
    plant.on_outputs(Cycles{now}, out);
    until(now + 100);
    out.step = 0;
    plant.on_outputs(Cycles{now}, out);
  }
  until(now + 5000);
  EXPECT_TRUE(mechanics.controlled);
  EXPECT_EQ(plant.motor_counts(0), Counts{3});
  EXPECT_EQ(plant.motor_counts(1), Counts{3});
  EXPECT_EQ(plant.motor_counts(2), Counts{0});
}

}  // namespace
}  // namespace armature::cosim
