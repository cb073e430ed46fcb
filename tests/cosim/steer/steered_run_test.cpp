// A run that is steered from outside is that of a scenario with the same commands, and can be repeated to any time.
#include "cosim/steer/steered_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "controller/base/angle_units.hpp"
#include "cosim/time/clock.hpp"
#include "tests/cosim/support/scenario_files.hpp"

namespace armature::cosim {
namespace {

using test::kScenarios;
using test::shipped;
using testing::HasSubstr;

constexpr Cycles kAll{std::numeric_limits<std::int64_t>::max() / 2};

Scenario shipped_scenario(const char* name, const std::vector<std::string>& set = {}) {
  return load_scenario(kScenarios / name,
                       {.search_path = kScenarios, .overrides = set, .logic = {.engine = Engine::kModel}});
}

std::string digest_of(const Scenario& scenario) {
  SteeredRun run{scenario, {}};
  run.advance(kAll);
  return run.digest();
}

void go_to(SteeredRun& run, double time_s) {
  run.advance(to_cycles(time_s) - run.now());
}

const std::int64_t* integers(const SteeredRun& run, std::string_view name) {
  const auto found = std::ranges::find(run.trace().blocks(), name, &TraceColumns::Block::name);
  return static_cast<const std::int64_t*>(found->data.get());
}

template <class Call>
std::string error_of_call(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(SteeredRun, JogsFromOutsideGiveTheRunOfAScenarioThatHasThem) {
  const Scenario scenario = shipped_scenario("jog");
  Scenario without = scenario;
  std::erase_if(without.moves, [](const CommandSpec& move) { return std::holds_alternative<JogSpec>(move.kind); });
  // The jogs behind the first move that are neither S-curves nor behind another move.
  Scenario with = without;
  std::vector<CommandSpec> jogs;
  for (const CommandSpec& move : scenario.moves) {
    const auto* jog = std::get_if<JogSpec>(&move.kind);
    if (jog != nullptr && jog->profile == ProfileKind::kTrapezoid && jog->accel_mm_s2 == JogSpec{}.accel_mm_s2) {
      jogs.push_back(move);
    }
  }
  ASSERT_GE(jogs.size(), 5);
  std::uint32_t index = 0;
  for (CommandSpec& move : without.moves) move.index = index++;
  with.moves = without.moves;
  for (CommandSpec& jog : jogs) jog.index = index++;
  with.moves.insert(with.moves.end(), jogs.begin(), jogs.end());
  SteeredRun run{without, {}};
  for (const CommandSpec& jog : jogs) {
    go_to(run, jog.at_s);
    run.jog(std::get<JogSpec>(jog.kind));
  }
  run.advance(kAll);
  EXPECT_EQ(run.digest(), digest_of(with));
  EXPECT_NE(run.digest(), digest_of(without));
  EXPECT_EQ(run.refused(), 1);  // the one behind the last move
  EXPECT_EQ(run.last_refusal(), "not_ready");
}

TEST(SteeredRun, SetPointsFromOutsideGiveTheRunOfAScenarioWithTheirStream) {
  const Scenario scenario = shipped_scenario("stream_1khz");
  const std::vector<StreamSpec> streams = scenario.streams;
  ASSERT_EQ(streams.size(), 2);
  Scenario without = scenario;
  without.streams.clear();
  Scenario with = scenario;
  with.streams[1].profile = ProfileKind::kTrapezoid;
  SteeredRun run{without, {}};
  for (const StreamSpec& stream : streams) {
    for (const StreamSpec::Point& point : stream.points) {
      run.advance(to_cycles(stream.at_s) + Cycles{kTickCycles * point.ticks} - run.now());
      run.send({.kind = stream.kind,
                .values = point.values,
                .last = &point == &stream.points.back(),
                .delay_ms = stream.delay_s() * 1e3});
    }
  }
  run.advance(kAll);
  EXPECT_EQ(run.digest(), digest_of(with));
  EXPECT_NE(run.digest(), digest_of(without));
}

TEST(SteeredRun, ASnapshotLeadsToTheSameStateAndTheSameRest) {
  Scenario scenario = shipped_scenario("jog");
  scenario.moves.clear();
  scenario.duration_s = 0.2;
  SteeredRun run{scenario, {}};
  const auto jog_on = [](SteeredRun& of, double deg_s) {
    of.jog({.joint_deg_s = PerAxis<double>{deg_s, -deg_s, 0, 0, 0, 0}, .duration_s = 0.004});
    of.advance(to_cycles(0.002) + Cycles{777});  // not at a tick
  };
  run.advance(to_cycles(0.01));
  for (int i = 0; i < 20; ++i) jog_on(run, 10 + i);
  const RunSnapshot snapshot = run.snapshot();
  const std::string digest = run.digest();
  for (int i = 0; i < 20; ++i) jog_on(run, 30 - i);
  run.advance(kAll);

  SteeredRun again{scenario, {}, snapshot};
  EXPECT_EQ(again.now(), snapshot.at);
  EXPECT_EQ(again.digest(), digest);
  EXPECT_EQ(again.snapshot().sent.size(), 20);
  for (int i = 0; i < 20; ++i) jog_on(again, 30 - i);
  again.advance(kAll);
  EXPECT_EQ(again.digest(), run.digest());
}

// A program may send for hours: the script drops what it has executed. Each of these is refused once.
TEST(SteeredRun, EachOfThousandsOfCommandsIsGivenOnce) {
  Scenario scenario = shipped_scenario("jog");
  scenario.moves.resize(1);
  SteeredRun run{scenario, {}};
  run.advance(to_cycles(0.05));
  constexpr std::size_t kSent = 2'400;
  for (std::size_t i = 0; i < kSent; ++i) {
    run.jog({.joint_deg_s = PerAxis<double>{20}, .duration_s = 0.001});
    run.advance(to_cycles(0.0001));
  }
  EXPECT_EQ(run.refused(), kSent);
  EXPECT_EQ(run.last_refusal(), "not_ready");
}

TEST(SteeredRun, EarlierRowsStayWhereTheyAreAndOutliveTheRun) {
  std::shared_ptr<void> kept;
  const std::int64_t* ticks = nullptr;
  {
    SteeredRun run{shipped_scenario("jog"), {.every_ticks = 20}};
    run.advance(to_cycles(0.6));
    ticks = integers(run, "tick");
    EXPECT_EQ(run.trace().rows(), 600);
    run.advance(to_cycles(0.6));
    EXPECT_EQ(integers(run, "tick"), ticks);
    EXPECT_EQ(run.trace().rows(), 1'200);
    kept = run.trace().blocks().front().data;
  }
  for (std::int64_t row = 0; row < 1'200; ++row) ASSERT_EQ(ticks[row], row * 20);
}

TEST(SteeredRun, WhatIsOutsideItsRangeIsRefusedAndHasNoEffect) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  Scenario scenario = shipped_scenario("jog");
  SteeredRun run{scenario, {}};
  const auto jog = [&run](const JogSpec& spec) { return error_of_call([&] { run.jog(spec); }); };
  EXPECT_THAT(jog({.joint_deg_s = PerAxis<double>{0, 0, none}, .duration_s = 1}), HasSubstr("jog: joint_deg_s[2]"));
  EXPECT_THAT(jog({.joint_deg_s = PerAxis<double>{2e6}, .duration_s = 1}), HasSubstr("found 2000000"));
  EXPECT_THAT(jog({.joint_deg_s = PerAxis<double>{}, .duration_s = 0}), HasSubstr("duration_s"));
  EXPECT_THAT(jog({.joint_deg_s = PerAxis<double>{}, .duration_s = 1, .accel_percent = 0}), HasSubstr("accel_percent"));
  EXPECT_THAT(jog({.frame_name = "tabel", .duration_s = 1}), HasSubstr("unknown frame \"tabel\""));
  const auto send = [&run](const SetPoint& point) { return error_of_call([&] { run.send(point); }); };
  EXPECT_THAT(send({.values = {0, none}}), HasSubstr("set-point: joints_deg[1]"));
  EXPECT_THAT(send({.kind = StreamSpec::Kind::kTool, .values = {0, 0, 0, none}}), HasSubstr("rpy_deg[0]"));
  EXPECT_THAT(send({.delay_ms = 0}), HasSubstr("delay_ms"));
  EXPECT_EQ(send({}), "");
  EXPECT_THAT(send({}), HasSubstr("later than the one before"));
  run.advance(Cycles{kTickCycles + 1});
  EXPECT_THAT(send({}), HasSubstr("whole number of ticks"));
  EXPECT_THAT(send({.kind = StreamSpec::Kind::kTool}), HasSubstr("either"));
  EXPECT_EQ(run.snapshot().sent.size(), 1);
  run.advance(kAll);
  EXPECT_THAT(jog({.joint_deg_s = PerAxis<double>{}, .duration_s = 1}), HasSubstr("the run is over"));
}

}  // namespace
}  // namespace armature::cosim
