// The list of facts: each entry is complete, and its keys are keys that a scenario can have.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "cosim/report/facts/fact.hpp"
#include "cosim/report/judge/comparison.hpp"
#include "tests/cosim/support/scenario_files.hpp"

namespace armature::cosim {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(FactList, HasEachNameAndEachKeyOnce) {
  std::set<std::string_view> names;
  std::set<std::string_view> keys;
  for (const Fact& fact : fact_list()) {
    EXPECT_TRUE(names.insert(fact.name).second) << fact.name;
    EXPECT_FALSE(fact.meaning.empty()) << fact.name;
    EXPECT_NE(fact.value, nullptr) << fact.name;
    for (const Expectation& one : fact.expectations) EXPECT_TRUE(keys.insert(one.key).second) << one.key;
  }
}

TEST(FactList, HasKeysOfExpectOnly) {
  const test::TempFolder folder;
  for (const Fact& fact : fact_list()) {
    for (const Expectation& one : fact.expectations) {
      const std::string key{one.key};
      const auto file =
          folder.write("s/scenario.toml", "robot = \"vo2021_6r\"\nduration_s = 1\nexpect." + key + " = {}\n");
      const std::string error = test::error_of(file);  // no key of [expect] is a table
      EXPECT_THAT(error, HasSubstr("expect." + key + ": "));
      EXPECT_THAT(error, Not(HasSubstr("expect." + key + ": unknown key")));
    }
  }
}

TEST(FactList, AValueMeetsAnExpectationOfItself) {
  RunFacts facts;
  facts.moves.resize(1);
  facts.stopped_by = "estop";
  facts.final_load_deg = facts.lost_motion_deg = PerAxis<double>{1, 2, 3, 4, 5, 6};
  facts.final_tcp_mm = Eigen::Vector3d{1, 2, 3};
  facts.final_rotation = Eigen::Matrix3d::Identity();
  Scenario scenario;
  scenario.program_files.push_back({.name = "part.ngc", .text = {}});
  facts.names = CommandNames{scenario};
  facts.program_events.push_back({.note = {.place = 7, .kind = ProgramNoted::Kind::kEnded}, .at = Cycles{7}});
  facts.outputs.push_back({.pin = 3, .level = true, .at = Cycles{7}});
  int compared = 0;
  for (const Fact& fact : fact_list()) {
    for (const Expectation& one : fact.expectations) {
      if (one.relation != Relation::kEqual && one.relation != Relation::kWithin) continue;
      EXPECT_TRUE(compare(fact, one, fact.value(facts), 1e-9, facts).met) << one.key;
      ++compared;
    }
  }
  EXPECT_GT(compared, 20);
}

}  // namespace
}  // namespace armature::cosim
