// A run does not depend on the steps in which it is advanced, nor on other runs of the process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "controller/base/timebase.hpp"
#include "cosim/time/clock.hpp"
#include "tests/cosim/run/recorded_run.hpp"

namespace armature::cosim {
namespace {

using test::lively_scenario;
using test::pendant_scenario;
using test::RecordedRun;
using test::RunTexts;
using test::RunUnderTest;
using testing::HasSubstr;

RunTexts in_one_go(const Scenario& scenario) {
  RecordedRun recorded{scenario};
  EXPECT_FALSE(recorded.run().advance(Cycles{std::numeric_limits<std::int64_t>::max()}));
  return recorded.finish();
}

RunTexts in_steps(const Scenario& scenario, Cycles step) {
  RecordedRun recorded{scenario};
  RunUnderTest& run = recorded.run();
  while (run.advance(run.now() + step)) {
  }
  return recorded.finish();
}

void expect_equal(const RunTexts& got, const RunTexts& wanted) {
  EXPECT_TRUE(got.trace == wanted.trace);
  EXPECT_TRUE(got.load == wanted.load);
  EXPECT_EQ(got.log, wanted.log);
  EXPECT_EQ(got.serial, wanted.serial);
  EXPECT_EQ(got.summary, wanted.summary);
}

// Without this the comparisons below could compare runs in which nothing happens.
TEST(RunSteps, TheScenariosAreNotEmpty) {
  const RunTexts lively = in_one_go(lively_scenario());
  EXPECT_EQ(std::count(lively.trace.begin(), lively.trace.end(), '\n'), 1'200);
  for (const char* line : {"state moving", "output: pin 2 = 1", "input: pin 3 = 1", "fault: estop", "end\n"}) {
    EXPECT_THAT(lively.log, HasSubstr(line));
  }
  EXPECT_THAT(lively.serial, HasSubstr(",rx,"));
  const RunTexts pendant = in_one_go(pendant_scenario());
  EXPECT_THAT(pendant.serial, HasSubstr(",rx,"));
  EXPECT_THAT(pendant.serial, HasSubstr(",tx,"));
}

TEST(RunSteps, TheirSizeChangesNoByte) {
  for (const Scenario& scenario : {lively_scenario(), pendant_scenario()}) {
    SCOPED_TRACE(scenario.name);
    const RunTexts whole = in_one_go(scenario);
    for (const Cycles step : {armature::kTickCycles, to_cycles(1.0), Cycles{777}}) {
      SCOPED_TRACE(testing::Message() << step.value() << " cycles");
      expect_equal(in_steps(scenario, step), whole);
    }
  }
}

TEST(RunSteps, AStepEndsInItsCycle) {
  const Scenario scenario = lively_scenario();
  RunUnderTest run{scenario};
  EXPECT_TRUE(run.advance(Cycles{12'345}));
  EXPECT_EQ(run.now(), Cycles{12'345});
  EXPECT_TRUE(run.advance(Cycles{100})) << "a cycle that has passed";
  EXPECT_EQ(run.now(), Cycles{12'345});
}

TEST(RunSteps, TwoRunsThatTakeTurnsGiveWhatTheyGiveAlone) {
  const Scenario lively = lively_scenario(), pendant = pendant_scenario();
  RecordedRun first{lively}, second{pendant}, third{lively};
  bool continues = true;
  while (continues) {
    continues = first.run().advance(first.run().now() + Cycles{911});
    continues |= second.run().advance(second.run().now() + armature::kTickCycles);
    continues |= third.run().advance(third.run().now() + Cycles{50'000});
  }
  const RunTexts alone = in_one_go(lively);
  expect_equal(first.finish(), alone);
  expect_equal(second.finish(), in_one_go(pendant));
  expect_equal(third.finish(), alone);
}

}  // namespace
}  // namespace armature::cosim
