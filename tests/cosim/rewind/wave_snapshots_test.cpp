// The waveform of a moment that has passed is that of a run in which the moment was known.
#include "cosim/rewind/wave_snapshots.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <string>

#include "cosim/golden/golden.hpp"
#include "cosim/run/golden_listener.hpp"
#include "cosim/run/trace_listener.hpp"
#include "cosim/time/clock.hpp"
#include "tests/cosim/run/recorded_run.hpp"
#include "tests/cosim/snapshot/refused_copies.hpp"

namespace armature::cosim {
namespace {

using test::lively_scenario;
using test::read_file;
using test::RecordedRun;
using test::RunTexts;
using test::RunUnderTest;
using test::TempFolder;

bool never() {
  return false;
}

Scenario lively_rtl() {
  Scenario scenario = lively_scenario();
  scenario.engine = Engine::kRtl;
  return scenario;
}

struct Shown {
  std::optional<WaveMoment> moment;
  std::optional<Cycles> until;
  bool early = false;  // the waveform was ordered before the end
  std::string wave;
};

// `golden`: of the scenario; null: the run is not compared with it.
Shown with_snapshots(const Scenario& scenario, const MomentWave& wanted, GoldenListener* golden = nullptr) {
  const TempFolder folder;
  const std::filesystem::path file = folder.path() / "w.vcd";
  RunUnderTest run{scenario};
  if (golden != nullptr) run.add(*golden);
  WaveSnapshots snapshots{{scenario, run, golden, never}, {wanted, {.file = file}}};
  do {
    snapshots.after_step();
  } while (run.advance(run.now() + armature::kTickCycles));
  const RunSummary summary = run.finish();
  Shown shown{
      .moment = shown_moment(wanted, summary), .until = {}, .early = snapshots.ordered().has_value(), .wave = {}};
  if (shown.moment) shown.until = snapshots.write(*shown.moment);
  if (shown.until) shown.wave = read_file(file);
  return shown;
}

std::string plain_wave(const Scenario& scenario, const WaveSpan& span) {
  const TempFolder folder;
  const std::filesystem::path file = folder.path() / "w.vcd";
  RunUnderTest run{scenario, {.wave = WaveRequest{.file = file, .from = span.from, .to = span.to}}};
  run.advance(span.to + Cycles{1});
  (void)run.finish();
  return read_file(file);
}

void expect_plain_wave(const Scenario& scenario, const MomentWave& wanted, const Shown& shown) {
  ASSERT_TRUE(shown.moment);
  ASSERT_TRUE(shown.until);
  const WaveSpan span = span_of(wanted, *shown.moment);
  EXPECT_EQ(*shown.until, span.to);
  EXPECT_GT(shown.wave.size(), 100'000u);
  EXPECT_TRUE(shown.wave == plain_wave(scenario, span)) << "other bytes";
}

bool has_child() {
  return ::waitpid(-1, nullptr, WNOHANG) != -1 || errno != ECHILD;
}

TEST(WaveSnapshots, ShowAFaultWhileTheRunGoesOn) {
  const Scenario scenario = lively_rtl();
  const MomentWave wanted{.reason = WaveReason::kFault, .before = to_cycles(0.0005), .to = to_cycles(0.0452)};
  const Shown shown = with_snapshots(scenario, wanted);
  expect_plain_wave(scenario, wanted, shown);
  EXPECT_TRUE(shown.early);
  EXPECT_EQ(shown.moment->what, "the fault estop");
  EXPECT_FALSE(has_child());
}

// The caller can write the waveform in a second run.
TEST(WaveSnapshots, LeaveTheRunAloneWhereTheHostRefusesThem) {
  const auto run = [] {
    test::refuse_copies();
    const Shown shown = with_snapshots(lively_rtl(), {.reason = WaveReason::kFault, .before = to_cycles(0.0005)});
    ::_exit(shown.moment && !shown.early && !shown.until ? 0 : 1);
  };
  EXPECT_EXIT(run(), testing::ExitedWithCode(0), "");
}

TEST(WaveSnapshots, ShowTheBeginOfTheRunIfTheMomentIsEarly) {
  const Scenario scenario = lively_rtl();
  const MomentWave wanted{.reason = WaveReason::kFault, .before = to_cycles(0.5), .to = to_cycles(0.0005)};
  const TempFolder folder;
  RunUnderTest run{scenario};
  WaveSnapshots snapshots{{scenario, run, nullptr, never}, {wanted, {.file = folder.path() / "w.vcd"}}};
  snapshots.after_step();
  run.advance(to_cycles(0.001));
  const WaveMoment moment{.what = "m", .from = Cycles{10'000}, .to = Cycles{10'000}};
  EXPECT_EQ(snapshots.write(moment), to_cycles(0.0005));
  EXPECT_TRUE(read_file(folder.path() / "w.vcd") == plain_wave(scenario, {Cycles{0}, to_cycles(0.0005)}));
}

// Only the end of the run decides whether an expectation is met. By then its moment is long past.
TEST(WaveSnapshots, ShowAFailedExpectation) {
  Scenario scenario = lively_rtl();
  scenario.duration_s = 0.12;
  const MomentWave wanted{.reason = WaveReason::kFail, .before = to_cycles(0.0005), .to = to_cycles(0.0452)};
  const Shown shown = with_snapshots(scenario, wanted);
  expect_plain_wave(scenario, wanted, shown);
  EXPECT_FALSE(shown.early);
  EXPECT_LT(shown.moment->to, to_cycles(0.05));
  EXPECT_FALSE(has_child());
}

// A row of the golden comes every 10 ms, so a difference is seen as much later.
TEST(WaveSnapshots, ShowADifferenceFromTheGolden) {
  const TempFolder folder;
  Scenario scenario = lively_rtl();
  scenario.file = (folder.path() / "scenario.toml").string();
  scenario.golden.sha256 = std::string(64, 'a');
  {
    TraceListener trace{scenario, {.file = golden_file(scenario), .every_ticks = kGoldenEveryTicks}};
    RunUnderTest run{scenario};
    run.add(trace);
    run.advance(to_cycles(0.07));
    (void)run.finish();
  }
  std::string text = read_file(golden_file(scenario));
  text.replace(text.find("\n800,") + 1, 4, "801,");  // a row that the run does not have, in place of the one at 40 ms
  std::ofstream{golden_file(scenario)} << text;
  GoldenListener golden{scenario, {.file = "trace.csv", .every_ticks = 1}};
  const MomentWave wanted{.reason = WaveReason::kMismatch, .before = Cycles{0}, .to = to_cycles(0.0304)};
  const Shown shown = with_snapshots(scenario, wanted, &golden);
  EXPECT_TRUE(shown.early);
  expect_plain_wave(scenario, wanted, shown);
}

TEST(WaveSnapshots, ChangeNothingInTheRun) {
  const Scenario scenario = lively_rtl();
  const auto texts = [&](bool with) {
    const TempFolder folder;
    RecordedRun recorded{scenario};
    RunUnderTest& run = recorded.run();
    std::optional<WaveSnapshots> snapshots;
    const MomentWaveRequest request{{.reason = WaveReason::kFault}, {.file = folder.path() / "w.vcd"}};
    if (with) snapshots.emplace(WaveSnapshots::Parts{scenario, run, nullptr, never}, request);
    do {
      if (snapshots) snapshots->after_step();
    } while (run.advance(run.now() + armature::kTickCycles));
    return recorded.finish();
  };
  EXPECT_TRUE(texts(true) == texts(false));
}

TEST(WaveSnapshots, ARunWithoutTheMomentLeavesNoFileAndNoProcess) {
  Scenario scenario = lively_rtl();
  scenario.duration_s = 0.04;
  const Shown shown = with_snapshots(scenario, {.reason = WaveReason::kFault});
  EXPECT_FALSE(shown.moment);
  EXPECT_FALSE(has_child());
}

TEST(WaveSnapshots, AFileThatCannotBeWrittenIsAnError) {
  const Scenario scenario = lively_rtl();
  RunUnderTest run{scenario};
  const MomentWave wanted{.reason = WaveReason::kFault};
  WaveSnapshots snapshots{{scenario, run, nullptr, never}, {wanted, {.file = "/nowhere/w.vcd"}}};
  snapshots.after_step();
  EXPECT_THROW((void)snapshots.write({.what = "m", .from = Cycles{0}, .to = Cycles{0}}), std::runtime_error);
}

}  // namespace
}  // namespace armature::cosim
