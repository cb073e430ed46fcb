// --set of the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/cosim/support/scenario_files.hpp"

namespace armature::cosim {
namespace {

using test::error_of;
using test::shipped;
using testing::HasSubstr;

TEST(ScenarioOverride, ChangesScalarsElementsAndWholeValues) {
  LoadOptions options = shipped();
  options.overrides = {"controller.feedback=false",
                       "controller.sync=const_acc",
                       "seed=7",
                       "move[0].target_deg[2]=12.5",
                       "bus={ latency_cycles = 9 }",
                       "description=\"quoted\"",
                       "expect.total_pulses=[1, 2, 3, 4, 5, 6]",
                       "move[0].at_s = 0.25"};
  // The last one has a blank around `=`; blanks are not part of a key.
  EXPECT_THAT(error_of("fig9_joint_move", options), HasSubstr("--set move[0].at_s = 0.25: expected key=value"));
  options.overrides.back() = "move[0].at_s=0.25";
  const Scenario s = load_scenario("fig9_joint_move", options);
  EXPECT_FALSE(s.controller.feedback);
  EXPECT_EQ(s.controller.sync, "const_acc");
  EXPECT_EQ(s.seed, 7u);
  EXPECT_EQ(std::get<JointSpec>(s.moves[0].kind).target_deg.value()[2], 12.5);
  EXPECT_EQ(s.bus.latency_cycles, 9);
  EXPECT_EQ(s.description, "quoted");
  EXPECT_EQ(s.expect.total_pulses.value()[5], 6);
  EXPECT_EQ(s.moves[0].at_s, 0.25);
}

TEST(ScenarioOverride, NamesTheOverrideInEveryMessage) {
  const std::pair<const char*, const char*> cases[] = {
      {"controller.feedbak=1", "--set controller.feedbak=1: controller.feedbak: unknown key, did you mean feedback?"},
      {"contoller.feedback=true", "--set contoller.feedback=true: contoller: unknown key, did you mean controller?"},
      {"duration_s=-1", "--set duration_s=-1: duration_s: expected a number above 0 up to 86400 (s), found -1"},
      {"move[4].at_s=1", "--set move[4].at_s=1: move[4]: no such element, move has 1"},
      {"seed.x=1", "--set seed.x=1: seed: expected a table to set a key of, found 1"},
      {"seed", "--set seed: expected key=value with a dotted key, such as controller.feedback=false"},
      {"a b=1", "--set a b=1: expected key=value with a dotted key, such as controller.feedback=false"},
      {"move[0]at_s=1", "--set move[0]at_s=1: expected key=value with a dotted key, such as controller.feedback=false"},
      {"move[0].=1", "--set move[0].=1: expected key=value with a dotted key, such as controller.feedback=false"},
      {"move[x].at_s=1",
       "--set move[x].at_s=1: expected key=value with a dotted key, such as controller.feedback=false"},
      {"seed=1\nduration_s = 9",
       "--set seed=1\\nduration_s = 9: seed: expected an integer of at least 0, found the string \"1\\nduration_s = "
       "9\""},
  };
  for (const auto& [assignment, message] : cases) {
    LoadOptions options = shipped();
    options.overrides = {assignment};
    EXPECT_EQ(error_of("fig9_joint_move", options), message);
  }
}

}  // namespace
}  // namespace armature::cosim
