// summary.json.
#include "cosim/report/format/json/summary_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "controller/kinematics/ik_result.hpp"
#include "tests/cosim/support/sample_summary.hpp"

namespace armature::cosim {
namespace {

using test::sample_summary;

TEST(SummaryJson, KeepsWhatDependsOnTheMachineApart) {
  RunSummary summary = sample_summary();
  auto one = nlohmann::json::parse(summary_json(summary));
  summary.host.wall_s = 99;
  auto other = nlohmann::json::parse(summary_json(summary));
  EXPECT_NE(one, other);
  one.erase("host");
  other.erase("host");
  EXPECT_EQ(one, other);
  const auto& result = one["result"];
  EXPECT_EQ(result["passed"], true);
  EXPECT_EQ(result["outcome"], "fault:following_error");
  EXPECT_EQ(result["cycles"], 25'000'000);
  EXPECT_EQ(result["moves_finished"], 2);
  EXPECT_EQ(result["worst_tick_cycles"], 625);
  EXPECT_EQ(result["failure"], nullptr);
  EXPECT_EQ(result["settle_s"], nullptr);
  EXPECT_EQ(result["faults"][0]["cause"], "following_error");
  EXPECT_EQ(result["faults"][0]["axis"], 3);
  EXPECT_EQ(result["refused_moves"][0]["reason"], "outside_limits");
  EXPECT_NEAR(result["refused_moves"][0]["target_deg"], 120, 1e-9);
  EXPECT_NEAR(result["refused_moves"][0]["limit_deg"], 110, 1e-9);
  EXPECT_EQ(result["worst_following_error_deg"][5], 0.9553);
  EXPECT_EQ(result["moves"][0]["taken_ticks"], 17);
  EXPECT_EQ(result["moves"][1]["taken_ticks"], nullptr);
}

TEST(SummaryJson, SaysWhyEachJogEnded) {
  RunSummary summary = sample_summary();
  summary.facts.jogs = {
      {{.tag = 2, .tick = Ticks{10}},
       JogEnded{.tag = 2, .how = JogEnd::kLimit, .axis = 3, .tick = Ticks{29}, .taken = Ticks{20}, .commands = 4}},
      {{.tag = 7, .tick = Ticks{50}}}};
  const auto jogs = nlohmann::json::parse(summary_json(summary))["result"]["jogs"];
  EXPECT_EQ(jogs[0]["move"], 2);
  EXPECT_EQ(jogs[0]["start_tick"], 10);
  EXPECT_EQ(jogs[0]["taken_ticks"], 20);
  EXPECT_EQ(jogs[0]["ended_by"], "limit");
  EXPECT_EQ(jogs[0]["axis"], 3);
  EXPECT_EQ(jogs[0]["commands"], 4);
  EXPECT_EQ(jogs[1]["ended_by"], nullptr);
}

TEST(SummaryJson, SaysHowTheHomingOfEachAxisEndedAndWhatItFound) {
  RunSummary summary = sample_summary();
  summary.facts.homings = {{{.tag = 2, .axis = 3, .tick = Ticks{10}},
                            HomingEnded{.tag = 2,
                                        .axis = 3,
                                        .how = HomingEnd::kHomed,
                                        .met = HomingSwitch::kLimit,
                                        .tick = Ticks{30},
                                        .taken = Ticks{20},
                                        .edge_to_index = Counts{1500},
                                        .shift = Counts{-7}}},
                           {{.tag = 2, .axis = 4, .tick = Ticks{10}},
                            HomingEnded{.tag = 2, .axis = 4, .how = HomingEnd::kNoIndex, .shift = Counts{9}}},
                           {{.tag = 2, .axis = 5, .tick = Ticks{50}}}};
  const auto axes = nlohmann::json::parse(summary_json(summary))["result"]["homings"];
  EXPECT_EQ(axes[0]["move"], 2);
  EXPECT_EQ(axes[0]["axis"], 3);
  EXPECT_EQ(axes[0]["start_tick"], 10);
  EXPECT_EQ(axes[0]["taken_ticks"], 20);
  EXPECT_EQ(axes[0]["ended_by"], "homed");
  EXPECT_EQ(axes[0]["met"], "a limit switch");
  EXPECT_EQ(axes[0]["edge_to_index_counts"], 1500);
  EXPECT_EQ(axes[0]["shift_counts"], -7);
  EXPECT_EQ(axes[1]["ended_by"], "no_index");
  EXPECT_EQ(axes[1]["shift_counts"], nullptr) << "not homed";
  EXPECT_EQ(axes[2]["ended_by"], nullptr) << "under way";
}

TEST(SummaryJson, TellsWhatTheRunWasMadeFrom) {
  RunSummary summary = sample_summary();
  summary.tool_version = "1.2.3";
  summary.seed = 42;
  summary.overrides = {"seed=42", "trace.every_ticks=1"};
  summary.sources = {{"s/scenario.toml", "aa"}, {"r/arm.toml", "bb"}};
  const auto json = nlohmann::json::parse(summary_json(summary));
  EXPECT_EQ(json["tool_version"], "1.2.3");
  EXPECT_EQ(json["seed"], 42);
  EXPECT_EQ(json["overrides"], (std::vector<std::string>{"seed=42", "trace.every_ticks=1"}));
  EXPECT_EQ(json["variant"], "counts");
  EXPECT_EQ(json["engine"], "rtl");
  EXPECT_EQ(json["inputs"].size(), 2u);
  EXPECT_EQ(json["inputs"][1]["file"], "r/arm.toml");
  EXPECT_EQ(json["inputs"][1]["sha256"], "bb");
}

TEST(SummaryJson, HoldsEachMissedExpectationWithItsPlace) {
  RunSummary summary = sample_summary();
  summary.expect_failures = {{.key = "max_correction_pulses",
                              .expected = "at most 3",
                              .got = "4",
                              .where = {"axis 2", {2}, RunPlace{.tick = 180, .at = Cycles{450'000}, .axis = 2}},
                              .file = "s/scenario.toml",
                              .origin = {17, 1, {}}},
                             {.key = "underruns", .expected = "0", .got = "5"}};
  const auto failures = nlohmann::json::parse(summary_json(summary))["result"]["expect_failures"];
  EXPECT_EQ(failures[0]["place"], "s/scenario.toml:17:1");
  EXPECT_EQ(failures[0]["axes"], std::vector<int>{2});
  EXPECT_EQ(failures[0]["tick"], 180);
  EXPECT_EQ(failures[0]["time_s"], 0.009);
  EXPECT_EQ(failures[0]["text"], summary.expect_failures[0].text());
  EXPECT_EQ(failures[1]["tick"], nullptr);
}

TEST(SummaryJson, HoldsPathsAndWhyTheyWereRefused) {
  RunSummary summary = sample_summary();
  MoveStarted& arc = summary.facts.moves[1];
  arc.kind = MoveKind::kArc;
  arc.stretch = 3.5;
  arc.stretched_for = 6;
  arc.continues = true;
  arc.path.shape = PositionPath::Shape::kArc;
  arc.path.radius_mm = 20;
  arc.path.end_mm = {0, 0, 40};
  MoveStarted& circle = summary.facts.moves[2];
  circle = arc;
  circle.path.end_mm = circle.path.start_mm;
  circle.unasked_stop = true;
  summary.facts.moves[0].peak_speed_rad_s[1] = std::numbers::pi;
  summary.facts.moves[0].accel_rad_s2[5] = std::numbers::pi / 2;
  summary.facts.refusals = {
      {{.reason = Refusal::kSingular,
        .axis = 4,
        .path = {.kind = PathProblem::Kind::kTooFast, .at = 0.5, .axis = 4, .singular = kWristSingular, .stretch = 45}},
       Cycles{7}}};
  summary.facts.path_error = PathDeviation{.mm = 0.5, .where = {.tick = 3, .at = Cycles{9}}, .move = 1};
  const auto result = nlohmann::json::parse(summary_json(summary))["result"];
  EXPECT_EQ(result["moves"][0]["kind"], "joint");
  EXPECT_FALSE(result["moves"][0].contains("path"));
  EXPECT_DOUBLE_EQ(result["moves"][0]["peak_speed_deg_s"][1], 180);
  EXPECT_DOUBLE_EQ(result["moves"][0]["accel_deg_s2"][5], 90);
  EXPECT_EQ(result["moves"][2]["kind"], "circle");
  EXPECT_EQ(result["moves"][1]["kind"], "arc");
  EXPECT_EQ(result["moves"][1]["stretch"], 3.5);
  EXPECT_EQ(result["moves"][1]["stretched_for_axis"], 6);
  EXPECT_EQ(result["moves"][1]["continues"], true);
  EXPECT_FALSE(result["moves"][1].contains("unasked_stop"));
  EXPECT_EQ(result["moves"][2]["unasked_stop"], true);
  EXPECT_EQ(result["unasked_stops"], 1);
  EXPECT_EQ(result["moves"][1]["path"]["radius_mm"], 20);
  EXPECT_FALSE(result["moves"][1].contains("profile"));
  EXPECT_EQ(result["refused_moves"][0]["reason"], "singular");
  EXPECT_EQ(result["refused_moves"][0]["path"]["singular"][0], "wrist");
  EXPECT_EQ(result["refused_moves"][0]["path"]["stretch"], 45);
  EXPECT_EQ(result["path_error"]["mm"], 0.5);
  EXPECT_EQ(result["command_path_error"], nullptr);
  EXPECT_EQ(result["final_tcp_mm"], nullptr);
}

}  // namespace
}  // namespace armature::cosim
