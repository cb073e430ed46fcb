#include "cosim/kernel/script/script.hpp"

#include <gtest/gtest.h>

#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

TEST(Clock, RoundsToTheNearestCycle) {
  EXPECT_EQ(to_cycles(0.01), Cycles{500'000});
  EXPECT_EQ(to_cycles(0.3), Cycles{15'000'000});
  EXPECT_EQ(to_cycles(19e-9), Cycles{1});
  EXPECT_DOUBLE_EQ(to_seconds(Cycles{kClkFreqHz}), 1.0);
}

TEST(Script, GivesEachActionOnceInTheOrderOfTime) {
  Scenario scenario;
  CommandSpec move;
  move.at_s = 2e-6;
  scenario.moves = {move};
  const FaultSpec estop{.at_s = 1e-6, .kind = Estop{.duration_s = 2e-6}};
  const FaultSpec loss{.at_s = 2e-6, .kind = PulseLoss{.axis = 3, .count = 500}};
  scenario.faults = {estop, loss};
  Script script{scenario};

  EXPECT_EQ(script.next_event(), Cycles{50});
  EXPECT_FALSE(script.pop_due(Cycles{49}));
  EXPECT_EQ(std::get<FaultSpec>(*script.pop_due(Cycles{50})), estop);
  EXPECT_FALSE(script.pop_due(Cycles{50}));
  EXPECT_EQ(script.next_event(), Cycles{100});
  EXPECT_EQ(std::get<FaultSpec>(*script.pop_due(Cycles{100})), loss);
  EXPECT_TRUE(std::holds_alternative<CommandSpec>(*script.pop_due(Cycles{100})));
  EXPECT_EQ(std::get<FaultEnd>(*script.pop_due(Cycles{150})).fault, estop);
  EXPECT_FALSE(script.next_event());
  EXPECT_FALSE(script.pop_due(Cycles{1'000'000}));
}

TEST(Script, TakesActionsWhileTheRunGoesOn) {
  Scenario scenario;
  CommandSpec move;
  move.at_s = 2e-6;
  scenario.moves = {move};
  scenario.inputs = {{.at_s = 2e-6, .pin = 1, .level = true}};
  const FaultSpec estop{.at_s = 2e-6, .kind = Estop{.duration_s = 1}};
  Script script{scenario};
  EXPECT_FALSE(script.pop_due(Cycles{99}));
  script.add(InputSpec{.at_s = 2e-6, .pin = 2, .level = true});
  script.add(estop);
  EXPECT_EQ(std::get<FaultSpec>(*script.pop_due(Cycles{100})), estop);
  EXPECT_EQ(std::get<InputSpec>(*script.pop_due(Cycles{100})).pin, 1);
  EXPECT_EQ(std::get<InputSpec>(*script.pop_due(Cycles{100})).pin, 2);
  EXPECT_TRUE(std::holds_alternative<CommandSpec>(*script.pop_due(Cycles{100})));
  EXPECT_EQ(script.next_event(), to_cycles(2e-6 + 1));
  script.end(estop, Cycles{100});
  EXPECT_EQ(script.next_event(), Cycles{101}) << "not in the cycle of its begin";
  EXPECT_EQ(std::get<FaultEnd>(*script.pop_due(Cycles{101})).fault, estop);
  EXPECT_FALSE(script.next_event());
}

TEST(Script, AFaultOfOneCycleEndsInALaterCycleWhateverItsTime) {
  constexpr double kCycleS = 1.0 / kClkFreqHz;
  // In the middle between two cycles, where begin and end can be rounded to the same one.
  for (int half = 1; half < 20'001; half += 2) {
    Scenario scenario;
    scenario.faults = {{.at_s = half * kCycleS / 2, .kind = Estop{.duration_s = kCycleS}}};
    Script script{scenario};
    const Cycles begin = script.next_event().value();
    ASSERT_TRUE(script.pop_due(begin));
    ASSERT_GT(script.next_event().value(), begin) << half;
  }
}

}  // namespace
}  // namespace armature::cosim
