// What listeners hear of a run, and when.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "controller/base/timebase.hpp"
#include "cosim/run/golden_listener.hpp"
#include "cosim/run/run.hpp"
#include "tests/cosim/run/recorded_run.hpp"

namespace armature::cosim {
namespace {

using test::RunUnderTest;
using testing::ElementsAre;
using testing::IsEmpty;

RunSummary run_to_end(Run& run) {
  while (run.advance(run.now() + armature::kTickCycles)) {
  }
  return run.finish();
}

class Rows final : public RunListener {
 public:
  void on_row(const TraceRow& row, const IntegerDigest& digest) override {
    ticks.push_back(row.tick);
    sha256 = digest.hex();
  }
  std::vector<std::int64_t> ticks;
  std::string sha256;
};

TEST(RunListener, EachOneGetsEachRowExactlyOnce) {
  const Scenario scenario = test::lively_scenario();
  Rows first, second;
  RunUnderTest run{scenario};
  run.add(first);
  run.add(second);
  const RunSummary summary = run_to_end(run);
  std::vector<std::int64_t> all(1'199);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(first.ticks, all);
  EXPECT_EQ(second.ticks, all);
  EXPECT_EQ(summary.facts.ticks, 1'199);
  EXPECT_EQ(first.sha256, summary.facts.sha256);
}

// An event between two rows is in the tick under way.
TEST(RunListener, HearsThePlaceOfEachThing) {
  class Places final : public RunListener {
   public:
    void on_row(const TraceRow& row, const IntegerDigest&) override { latest = row; }
    void on_event(const Event&, const RunPlace& place) override { events += is_now(place); }
    void on_action(const ScriptAction&, const RunPlace& place) override { actions += is_now(place); }
    void on_signal(const Signal&, const RunPlace& place) override { signals += is_now(place); }
    int events = 0, actions = 0, signals = 0;

   private:
    bool is_now(const RunPlace& place) {
      EXPECT_EQ(place.tick, latest.tick + 1);
      EXPECT_GE(place.at, Cycles{latest.cycle});
      EXPECT_TRUE(latest.tick < 0 || place.at <= Cycles{latest.cycle} + armature::kTickCycles);
      return true;
    }
    TraceRow latest{.telemetry = {}, .tick = -1};
  };
  const Scenario scenario = test::lively_scenario();
  Places places;
  RunUnderTest run{scenario};
  run.add(places);
  const RunSummary summary = run_to_end(run);
  EXPECT_GE(places.events, 4);  // a move begins and ends, an output is set, a fault
  EXPECT_EQ(places.actions, 6);
  EXPECT_GE(places.signals, 8 + 3);  // characters, servo enables, an output
  ASSERT_EQ(summary.facts.injected_faults.size(), 1u);
  EXPECT_EQ(summary.facts.injected_faults[0].when.at, Cycles{2'250'000});
  EXPECT_EQ(summary.facts.injected_faults[0].when.tick, 899);
}

TEST(RunListener, WritesThroughEveryTenthOfASecond) {
  class Written final : public RunListener {
   public:
    void on_row(const TraceRow& row, const IntegerDigest&) override { tick = row.tick; }
    void write_through() override { at.push_back(tick); }
    std::int64_t tick = -1;
    std::vector<std::int64_t> at;
  };
  Scenario scenario = test::scenario_with("");
  scenario.duration_s = 0.201;
  Written written;
  RunUnderTest run{scenario};
  run.add(written);
  (void)run_to_end(run);
  EXPECT_THAT(written.at, ElementsAre(0, 2'000, 4'000));
}

// Writes down its calls at the end.
class Judge final : public RunListener {
 public:
  Judge(std::string name, std::vector<std::string>& calls) : name_{std::move(name)}, calls_{calls} {}
  void judge(RunSummary& summary) override {
    calls_.push_back("judge " + name_);
    summary.golden.text += name_;
  }
  void on_end(const RunSummary& summary) override { calls_.push_back("end " + name_ + " " + summary.golden.text); }

 private:
  std::string name_;
  std::vector<std::string>& calls_;
};

TEST(RunListener, SeesAllVerdictsAtTheEnd) {
  Scenario scenario = test::lively_scenario();
  scenario.duration_s = 0.001;
  std::vector<std::string> calls;
  Judge a{"a", calls}, b{"b", calls};
  RunUnderTest run{scenario};
  run.add(a);
  run.add(b);
  EXPECT_EQ(run_to_end(run).golden.text, "ab");
  EXPECT_THAT(calls, ElementsAre("judge a", "judge b", "end a ab", "end b ab"));
}

TEST(RunListener, MayInterruptTheRun) {
  class Impatient final : public RunListener {
   public:
    explicit Impatient(RunUnderTest& run) : run_{run} {}
    void on_row(const TraceRow& row, const IntegerDigest&) override {
      ++rows;
      if (row.tick == 9) run_.interrupt();
    }
    int rows = 0;

   private:
    RunUnderTest& run_;
  };
  const Scenario scenario = test::lively_scenario();
  RunUnderTest run{scenario};
  Impatient impatient{run};
  run.add(impatient);
  EXPECT_FALSE(run.advance(Cycles{50'000'000}));
  const RunSummary summary = run.finish();
  EXPECT_TRUE(summary.interrupted);
  EXPECT_EQ(impatient.rows, 10);
  EXPECT_EQ(summary.facts.ticks, 10);
  EXPECT_THAT(summary.expect_failures, IsEmpty()) << "an interrupted run is not judged";
}

TEST(GoldenListener, ComparesNoRunThatDoesNotReachItsEnd) {
  const Scenario scenario = test::lively_scenario();
  RunSummary summary = summary_before_run(scenario);
  GoldenListener golden{scenario, {.file = "trace.csv", .every_ticks = 1}};
  golden.judge(summary);
  EXPECT_EQ(summary.golden.verdict, GoldenVerdict::kNotCompared);
  EXPECT_EQ(summary.golden.text, "the run was interrupted");
  summary.interrupted = false;
  summary.failure = "bus";
  golden.judge(summary);
  EXPECT_EQ(summary.golden.verdict, GoldenVerdict::kNotCompared);
  EXPECT_EQ(summary.golden.text, "the run failed before its end");
  summary.failure.reset();
  golden.judge(summary);
  EXPECT_EQ(summary.golden.verdict, GoldenVerdict::kNone);
}

}  // namespace
}  // namespace armature::cosim
