// The table of a campaign adds up, and its texts name what failed.
#include "cosim/campaign/campaign_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cosim/campaign/campaign_report.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

using testing::HasSubstr;
using testing::Not;

CampaignResult result(std::int64_t run, const std::vector<std::string>& kinds, Outcome outcome,
                      std::optional<std::int64_t> latency = {}) {
  return {.run = run,
          .kinds = kinds,
          .faults = kinds,
          .verdict = {.outcome = outcome, .reason = "a reason", .latency_ticks = latency}};
}

CampaignTable table_of(const std::vector<CampaignResult>& results, const std::string& shard = {}) {
  CampaignTable table{.head = {.seed = 1, .runs = 6, .engine = "model", .robots = {"r"}}};
  if (!shard.empty()) table.shards = {shard};
  for (const CampaignResult& one : results) table.add(one);
  return table;
}

const std::vector<CampaignResult> kFirst{result(0, {}, Outcome::kFinished), result(1, {"estop"}, Outcome::kStopped, 1),
                                         result(2, {"estop"}, Outcome::kStopped, 9)};
const std::vector<CampaignResult> kSecond{result(3, {"estop", "slow_core"}, Outcome::kHang),
                                          result(4, {"estop"}, Outcome::kStopped, 2),
                                          result(5, {"estop", "estop"}, Outcome::kMasked)};

TEST(CampaignTable, OfShardsIsThatOfTheWhole) {
  std::vector<CampaignResult> all = kFirst;
  all.insert(all.end(), kSecond.begin(), kSecond.end());
  for (const bool swapped : {false, true}) {
    CampaignTable merged = table_of(swapped ? kSecond : kFirst, swapped ? "1/2" : "0/2");
    merged.merge(table_of(swapped ? kFirst : kSecond, swapped ? "0/2" : "1/2"), "other");
    EXPECT_EQ(to_json(merged), to_json(table_of(all)));
  }
}

TEST(CampaignTable, IsTheSameFromItsFile) {
  const CampaignTable table = table_of(kSecond, "1/2");
  EXPECT_EQ(to_json(campaign_table(to_json(table).dump(), "file")), to_json(table));
}

TEST(CampaignTable, RefusesWhatDoesNotBelongTogether) {
  CampaignTable table = table_of(kFirst, "0/2");
  EXPECT_THROW(table.merge(table_of(kFirst, "0/2"), "file"), InputError);
  EXPECT_THROW(table.merge(table_of(kSecond), "file"), InputError);
  CampaignTable other = table_of(kSecond, "1/2");
  other.head.seed = 2;
  EXPECT_THROW(table.merge(other, "file"), InputError);
  EXPECT_THROW((void)campaign_table("{}", "file"), InputError);
  EXPECT_THROW((void)campaign_table("no JSON", "file"), InputError);
}

TEST(CampaignTable, HasTheQuantilesOfTheLatency) {
  LatencyCounts counts;
  for (std::int64_t ticks = 1; ticks <= 200; ++ticks) counts[ticks] = 1;
  const Latency latency = latency_of(counts);
  EXPECT_EQ(latency.least, 1);
  EXPECT_EQ(latency.median, 100);
  EXPECT_EQ(latency.most_of_all, 198);
  EXPECT_EQ(latency.most, 200);
}

TEST(CampaignReport, NamesEachSilentErrorAndTheCommandThatRepeatsIt) {
  const CampaignTable table = table_of(kSecond);
  EXPECT_EQ(silent_run_text(table.silent.at(0), "armature campaign --seed 1"),
            "SILENT  run 3: hang: a reason\n      estop\n      slow_core\n"
            "      to repeat it: armature campaign --seed 1 --only 3\n");
  EXPECT_THAT(campaign_page(table, "replay"), HasSubstr("replay --only 3"));
  EXPECT_THAT(campaign_page(table_of(kFirst), "replay"), Not(HasSubstr("replay")));
  EXPECT_THAT(campaign_text(table), HasSubstr("1 masked, 1 hang"));
}

TEST(CampaignReport, FailsTheCasesOfTheKindsOfASilentError) {
  std::vector<std::string> failed;
  for (const JunitCase& one : campaign_cases(table_of(kSecond), "replay")) {
    if (!one.failure.empty()) failed.push_back(one.name);
  }
  EXPECT_THAT(failed, testing::ElementsAre("slow_core", "estop"));
}

}  // namespace
}  // namespace armature::cosim
