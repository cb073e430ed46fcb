#include <gtest/gtest.h>

#include "controller/regs/soc_map.hpp"
#include "cosim/plant/clock.hpp"
#include "cosim/plant/step_input.hpp"

namespace armature::cosim {
namespace {

constexpr StepTiming kTiming{
    .min_high = Cycles{6}, .min_low = Cycles{7}, .dir_setup = Cycles{25}, .dir_hold = Cycles{30}};

// A pulse up, a reversal, a pulse down and another one, each time as given.
struct Times {
  std::int64_t high = 6;
  std::int64_t hold = 30;
  std::int64_t setup = 25;
  std::int64_t low = 7;
};

StepInput play(const Times& times, bool checked = true) {
  StepInput input{2, kTiming};
  Cycles now{1000};
  input.update(now, false, true, checked);
  now += Cycles{100};
  EXPECT_EQ(input.update(now, true, true, checked), +1);
  now += Cycles{times.high};
  EXPECT_EQ(input.update(now, false, true, checked), 0);
  now += Cycles{times.hold};
  EXPECT_EQ(input.update(now, false, false, checked), 0);
  now += Cycles{times.setup};
  EXPECT_EQ(input.update(now, true, false, checked), -1);
  now += Cycles{times.high};
  input.update(now, false, false, checked);
  now += Cycles{times.low};
  EXPECT_EQ(input.update(now, true, false, checked), -1);
  return input;
}

void expect_violation(const StepInput& input, InputRule rule, std::int64_t cycle, std::int64_t measured,
                      std::int64_t required) {
  ASSERT_TRUE(input.violation());
  EXPECT_EQ(input.violation()->axis, 2u);
  EXPECT_EQ(input.violation()->rule, rule);
  EXPECT_EQ(input.violation()->cycle.value(), cycle);
  EXPECT_EQ(input.violation()->measured.value(), measured);
  EXPECT_EQ(input.violation()->required.value(), required);
}

TEST(StepInput, AcceptsEveryTimeAtItsExactLimit) {
  EXPECT_FALSE(play({}).violation());
}

TEST(StepInput, ReportsAHighTimeOneCycleShort) {
  expect_violation(play({.high = 5}), InputRule::kStepHigh, 1105, 5, 6);
}

TEST(StepInput, ReportsALowTimeOneCycleShort) {
  expect_violation(play({.low = 6}), InputRule::kStepLow, 1100 + 6 + 30 + 25 + 6 + 6, 6, 7);
}

TEST(StepInput, ReportsADirectionSetUpOneCycleShort) {
  expect_violation(play({.setup = 24}), InputRule::kDirSetup, 1100 + 6 + 30 + 24, 24, 25);
}

TEST(StepInput, ReportsADirectionHoldOneCycleShort) {
  expect_violation(play({.hold = 29}), InputRule::kDirHold, 1100 + 6 + 29, 29, 30);
}

TEST(StepInput, ReportsADirectionChangeWhileStepIsHigh) {
  StepInput input{2, kTiming};
  input.update(Cycles{100}, true, false, true);
  input.update(Cycles{200}, true, true, true);
  expect_violation(input, InputRule::kDirHold, 200, 0, 30);
}

TEST(StepInput, ReportsADirectionChangeTogetherWithAnEdgeOfStep) {
  StepInput falling{2, kTiming};
  falling.update(Cycles{100}, true, false, true);
  falling.update(Cycles{200}, false, true, true);
  expect_violation(falling, InputRule::kDirHold, 200, 0, 30);

  StepInput rising{2, kTiming};
  EXPECT_EQ(rising.update(Cycles{100}, true, true, true), +1);
  expect_violation(rising, InputRule::kDirSetup, 100, 0, 25);
}

TEST(StepInput, KeepsTheFirstViolation) {
  StepInput input = play({.high = 3, .setup = 2});
  expect_violation(input, InputRule::kStepHigh, 1103, 3, 6);
}

TEST(StepInput, DoesNotJudgeWhileTheServoIsOff) {
  EXPECT_FALSE(play({.high = 1, .hold = 1, .setup = 1, .low = 1}, false).violation());
}

TEST(StepInput, MeasuresFromEdgesThatCameBeforeTheServoWasOn) {
  StepInput input{2, kTiming};
  input.update(Cycles{100}, false, true, false);
  EXPECT_EQ(input.update(Cycles{124}, true, true, true), +1);
  expect_violation(input, InputRule::kDirSetup, 124, 24, 25);
}

TEST(StepInput, AllowsAPulseOnTheFirstCycleOfTheRun) {
  StepInput input{0, kTiming};
  EXPECT_EQ(input.update(Cycles{1}, true, false, true), -1);
  EXPECT_FALSE(input.violation());
}

TEST(StepInput, RoundsTheTimesOfTheDataSheetUpToCycles) {
  DriveSpec spec;
  spec.min_step_high_ns = 100;
  spec.min_step_low_ns = 101;
  spec.dir_setup_ns = 500;
  spec.dir_hold_ns = 480.5;
  const StepTiming timing = StepTiming::from(spec);
  EXPECT_EQ(timing.min_high.value(), 5);
  EXPECT_EQ(timing.min_low.value(), 6);
  EXPECT_EQ(timing.dir_setup.value(), 25);
  EXPECT_EQ(timing.dir_hold.value(), 25);
}

TEST(StepInput, NamesAxisCycleRuleAndBothTimes) {
  EXPECT_EQ(describe({.axis = 2,
                      .cycle = Cycles{12345},
                      .rule = InputRule::kDirSetup,
                      .measured = Cycles{24},
                      .required = Cycles{25}}),
            "axis 3, cycle 12345: direction set-up 24 cycles (480 ns), the drive needs 25 cycles (500 ns)");
}

TEST(PlantClock, IsTheClockOfTheLogic) {
  EXPECT_EQ(kPlantClockHz, regs::soc::kClkFreqHz);
  EXPECT_EQ(regs::soc::kTickCycles % kPlantStep.value(), 0);
}

}  // namespace
}  // namespace armature::cosim
