#include "cosim/run/log_listener.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/run/run.hpp"
#include "tests/cosim/run/recorded_run.hpp"

namespace armature::cosim {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(LogListener, WritesWhatTheScenarioDoesAndWhatIsSeen) {
  const Scenario scenario = test::lively_scenario();
  test::RecordedRun recorded{scenario};
  EXPECT_FALSE(recorded.run().advance(Cycles{50'000'000}));
  const std::string log = recorded.finish().log;
  EXPECT_THAT(log, StartsWith("info: s: test\n"));
  for (const char* line : {
           "info: [0.030000 s] input: pin 3 = 1, at 0.030000 s (tick 599, cycle 1500000)\n",
           "warning: [0.045000 s] injected fault: estop for 0.01 s, at 0.045000 s (tick 899, cycle 2250000)\n",
           "info: [0.055000 s] injected fault ends: ",
           "output: pin 2 = 1\n",
           "servo enables of axes 6..1: 111111\n",
           "servo enables of axes 6..1: 000000\n",
           "error: [0.045022 s] fault: estop\n",
           "input at 0.030000 s (tick 599, cycle 1500000): pin 3 = 1: move[1] accepted it after ",
           "info: [0.060000 s] end\n",
       }) {
    EXPECT_THAT(log, HasSubstr(line));
  }
}

// The scenario does not expect the emergency stop.
TEST(LogListener, EndsWithTheVerdicts) {
  const Scenario scenario = test::lively_scenario();
  test::RecordedRun recorded{scenario};
  EXPECT_FALSE(recorded.run().advance(Cycles{50'000'000}));
  const std::string log = recorded.finish().log;
  const std::size_t end = log.find("s] end\n");
  ASSERT_NE(end, std::string::npos);
  EXPECT_GT(log.find("error: not met: "), end);
  EXPECT_NE(log.find("error: not met: "), std::string::npos);
}

}  // namespace
}  // namespace armature::cosim
