#include "cosim/rewind/wave_moment.hpp"

#include <gtest/gtest.h>

namespace armature::cosim {
namespace {

RunSummary with_faults(std::vector<FaultEvent> faults) {
  RunSummary summary;
  summary.facts.cycles = Cycles{900};
  summary.facts.faults = std::move(faults);
  return summary;
}

FaultEvent fault_at(std::int64_t cycle, FaultCause cause = FaultCause::kEstop) {
  return {.cause = cause, .where = {.tick = 1, .at = Cycles{cycle}}};
}

ExpectFailure failure_at(std::string key, std::optional<std::int64_t> cycle) {
  ExpectFailure failure{.key = std::move(key), .expected = {}, .got = {}};
  if (cycle) failure.where.at = RunPlace{.tick = 1, .at = Cycles{*cycle}};
  return failure;
}

TEST(WaveMoment, OfFaultsIsTheFirstOneThatCounts) {
  const RunSummary summary =
      with_faults({fault_at(5, FaultCause::kDrivesOff), fault_at(100), fault_at(200, FaultCause::kWatchdog)});
  MomentWave wanted{.reason = WaveReason::kFault};
  EXPECT_EQ(shown_moment(wanted, summary)->from, Cycles{100}) << "drives that are off are no fault of the arm";
  EXPECT_EQ(shown_moment(wanted, summary)->what, "the fault estop");
  wanted.from = Cycles{101};
  EXPECT_EQ(shown_moment(wanted, summary)->what, "the fault watchdog");
  wanted.to = Cycles{199};
  EXPECT_FALSE(shown_moment(wanted, summary));
}

TEST(WaveMoment, OfFailuresIsTheEarliestOneOrTheEnd) {
  RunSummary summary = with_faults({fault_at(100)});
  const MomentWave wanted{.reason = WaveReason::kFail};
  EXPECT_FALSE(shown_moment(wanted, summary));
  summary.expect_failures = {failure_at("final_joint_deg", std::nullopt)};
  EXPECT_EQ(shown_moment(wanted, summary)->from, Cycles{900});
  EXPECT_TRUE(wave_moments(wanted, summary).empty()) << "not known before the end";
  summary.expect_failures.push_back(failure_at("underruns", 300));
  summary.expect_failures.push_back(failure_at("max_following_error_deg", 200));
  EXPECT_EQ(shown_moment(wanted, summary)->what, "expect.max_following_error_deg");
  EXPECT_EQ(wave_moments(wanted, summary).size(), 2u);
  RunSummary broken = with_faults({});
  broken.failure = "a pulse was lost";
  EXPECT_EQ(shown_moment(wanted, broken)->from, Cycles{900});
}

TEST(WaveMoment, OfAMismatchLastsFromTheLastEqualRow) {
  RunSummary summary = with_faults({});
  const MomentWave wanted{.reason = WaveReason::kMismatch, .before = Cycles{1'000}};
  EXPECT_FALSE(shown_moment(wanted, summary));
  summary.golden.begins = TimeSpan{.from_s = 0.01, .to_s = 0.02};
  const WaveMoment moment = shown_moment(wanted, summary).value();
  EXPECT_EQ(moment.from, Cycles{500'000});
  EXPECT_EQ(moment.to, Cycles{1'000'000});
  EXPECT_EQ(span_of(wanted, moment).from, Cycles{499'000});
  EXPECT_EQ(span_of(wanted, moment).to, Cycles{1'050'000}) << "1 ms after it";
}

TEST(WaveMoment, ItsWaveformBeginsNotBeforeTheRunAndEndsWhereTheUserSays) {
  MomentWave wanted{.before = Cycles{500}};
  const WaveMoment moment{.what = {}, .from = Cycles{300}, .to = Cycles{300}};
  EXPECT_EQ(span_of(wanted, moment).from, Cycles{0});
  wanted.to = Cycles{400};
  EXPECT_EQ(span_of(wanted, moment).to, Cycles{400});
}

}  // namespace
}  // namespace armature::cosim
