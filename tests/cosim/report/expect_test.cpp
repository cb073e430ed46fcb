#include "cosim/report/judge/expect.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include <functional>
#include <limits>

namespace armature::cosim {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

enum class Where : bool { kNo, kYes };  // expect_place_test.cpp is about it
std::vector<std::string> texts(const ExpectSpec& expect, const RunFacts& facts, Where where = Where::kNo) {
  std::vector<std::string> all;
  for (ExpectFailure failure : check(expect, facts)) {
    if (where == Where::kNo) failure.where = {};
    all.push_back(failure.text());
  }
  return all;
}

MoveStarted move_of(std::int64_t ticks) {
  MoveStarted move;
  move.duration = Ticks{ticks};
  move.shape.fill(ProfileShape::kTriangle);
  return move;
}

RunFacts good_run() {
  RunFacts facts;
  facts.final_joint_deg = {1, 2, 3, 4, 5, 6};
  facts.total_pulses = {10, 20, 30, 40, 50, 60};
  facts.final_error_counts = {0, 0, 1, 0, 0, 0};
  facts.peak_speed_deg_s = {10, 10, 10, 10, 10, 10};
  facts.peak_pulses_per_tick = 9;
  facts.max_correction_pulses = 3;
  facts.overshoot_counts = {0, 2, 0, 0, 0, 0};
  facts.inexact_ticks = {7, 0, 0, 0, 0, 0};
  facts.max_residual_pulses = 5;
  facts.lost_counts = {0, -8, 0, 0, 0, 0};
  facts.final_load_deg = PerAxis<double>{0, -0.05, 0, 0, 0, 0};
  facts.lost_motion_deg = PerAxis<double>{0, 0, 0, 0.08, 0, 0};
  facts.settle_s = 0.02;
  facts.corrected_ticks = 50;
  facts.uncorrected_ticks = 4;
  facts.solved_poses = 100;
  facts.solver_difference_pulses = 0.5;
  facts.homings = {
      {.started = {.axis = 1}, .ended = HomingEnded{.axis = 1, .how = HomingEnd::kNoIndex, .tick = Ticks{9}}},
      {.started = {.axis = 2}, .ended = HomingEnded{.axis = 2, .tick = Ticks{7}}}};
  facts.moves = {move_of(100), move_of(50)};
  facts.taken_ticks = {120, 50};
  facts.moves[1].kind = MoveKind::kLine;
  facts.moves[1].continues = true;
  facts.moves[1].stretch = 4;
  facts.moves[1].residual_rad = 0.0096;
  facts.moved = true;
  facts.held_s = 0.3;
  facts.final_rotation = Eigen::Matrix3d{Eigen::AngleAxisd{std::numbers::pi / 2, Eigen::Vector3d::UnitZ()}};
  facts.final_tcp_mm = Eigen::Vector3d{100, 200, 300};
  facts.path_error = PathDeviation{.mm = 0.05, .where = {.tick = 7, .at = {}}, .move = 0};
  facts.command_path_error = PathDeviation{.mm = 1e-9, .where = {.tick = 8, .at = {}}, .move = 1};
  facts.peak_tool_speed_mm_s = ToolPeak{.value = 250, .at = RunPlace{.tick = 8, .at = {}}};
  facts.peak_tool_accel_mm_s2 = ToolPeak{.value = 5000, .at = RunPlace{.tick = 9, .at = {}}};
  return facts;
}

ExpectSpec all_of_it() {
  ExpectSpec expect;
  expect.outcome = "completed";
  expect.final_joint_deg = PerAxis<double>{1, 2, 3, 4, 5, 6.0009};
  expect.total_pulses = PerAxis<std::int64_t>{10, 20, 30, 40, 50, 60};
  expect.final_error_counts = PerAxis<std::int64_t>{0, 0, 1, 0, 0, 0};
  expect.move_ticks = {100, 50};
  expect.taken_ticks = {120, 50};
  expect.profile = std::vector<std::string>(kAxes, "triangle");
  expect.peak_speed_deg_s = PerAxis<double>{10, 10, 10, 10, 10, 10.0009};
  expect.peak_pulses_per_tick = 9;
  expect.underruns = 0;
  expect.refused_moves = 0;
  expect.refusals = std::vector<std::string>{};
  expect.unfinished_moves = 0;
  expect.blended_moves = 1;
  expect.min_held_s = 0.3;
  expect.final_rpy_deg = {{0, 0, 90.009}};
  expect.max_path_error_mm = 0.05;
  expect.max_command_path_error_mm = 1e-6;
  expect.max_tool_speed_mm_s = 250;
  expect.max_tool_accel_mm_s2 = 5000;
  expect.final_tcp_mm = {{100, 200, 300.01}};
  expect.min_residual_deg = 0.5;
  expect.max_residual_deg = 0.6;
  expect.min_stretch = 4;
  expect.max_stretch = 4;
  expect.min_corrected_ticks = 50;
  expect.max_corrected_ticks = 50;
  expect.min_uncorrected_ticks = 4;
  expect.max_uncorrected_ticks = 4;
  expect.min_solved_poses = 100;
  expect.max_solver_difference_pulses = 0.5;
  expect.homing_ends = {{"homed", "no_index"}};
  expect.faults = std::vector<std::string>{};
  expect.settled_within_s = 0.02;
  expect.max_overshoot_counts = 2;
  expect.max_correction_pulses = 3;
  expect.inexact_ticks = PerAxis<std::int64_t>{7, 0, 0, 0, 0, 0};
  expect.max_residual_pulses = 5;
  expect.lost_counts = PerAxis<std::int64_t>{0, -8, 0, 0, 0, 0};
  expect.final_load_deg = PerAxis<double>{0, -0.05, 0, 0, 0, 0};
  expect.lost_motion_deg = PerAxis<double>{0, 0, 0, 0.08, 0, 0};
  expect.lost_motion_tolerance_deg = 0.01;
  return expect;
}

TEST(Expect, AcceptsARunThatMeetsEveryKey) {
  EXPECT_THAT(texts(all_of_it(), good_run()), IsEmpty());
}

TEST(Expect, WhatNothingMovedForIsNotMet) {
  RunFacts facts;
  ExpectSpec expect;
  expect.min_stretch = 1;
  expect.max_stretch = 2;
  expect.settled_within_s = 1;
  expect.profile = std::vector<std::string>(kAxes, "none");
  EXPECT_THAT(texts(expect, facts), testing::UnorderedElementsAre(
                                        "expect.profile: expected [none, none, none, none, none, none], got no move",
                                        "expect.min_stretch: expected at least 1, got no move on a line or an arc",
                                        "expect.max_stretch: expected at most 2, got no move on a line or an arc",
                                        "expect.settled_within_s: expected at most 1 s, got no motion"));
}

TEST(Expect, MovesThatDidNotEndFailARunThatDoesNotStateThem) {
  RunFacts facts;
  facts.moves_waiting = 1;
  EXPECT_THAT(texts({}, facts), testing::ElementsAre("expect.unfinished_moves: expected 0, as it is not stated, got 1: "
                                                     "1 waiting, 0 under way at the end"));
  ExpectSpec expect;
  expect.unfinished_moves = 1;
  EXPECT_THAT(texts(expect, facts), IsEmpty());
}

TEST(Expect, EachKeyFailsForItselfAndSaysWhatItGot) {
  struct Case {
    std::function<void(RunFacts&)> spoil;
    const char* message;
  };
  const Case cases[] = {
      {[](RunFacts& f) { f.end_fault = FaultCause::kEncoder; },
       "expect.outcome: expected completed, got fault:encoder"},
      {[](RunFacts& f) { f.final_joint_deg[5] = 5.9998; },
       "expect.final_joint_deg: expected [1, 2, 3, 4, 5, 6.0009] +-0.001, got [1, 2, 3, 4, 5, 5.9998] (axis 6 differs: "
       "expected 6.0009, got 5.9998, difference -0.0011)"},
      {[](RunFacts& f) { f.total_pulses[0] = 11; },
       "expect.total_pulses: expected [10, 20, 30, 40, 50, 60], got [11, 20, 30, 40, 50, 60] (axis 1 differs: expected "
       "10, got 11, difference 1)"},
      {[](RunFacts& f) { f.final_error_counts[2] = 0; },
       "expect.final_error_counts: expected [0, 0, 1, 0, 0, 0], got [0, 0, 0, 0, 0, 0] (axis 3 differs: expected 1, "
       "got 0, difference -1)"},
      {[](RunFacts& f) { f.moves[1].duration = Ticks{51}; }, "expect.move_ticks: expected [100, 50], got [100, 51]"},
      {[](RunFacts& f) { f.taken_ticks[0] = 119; }, "expect.taken_ticks: expected [120, 50], got [119, 50]"},
      {[](RunFacts& f) { f.taken_ticks[0].reset(); }, "expect.taken_ticks: expected [120, 50], got [50]"},
      {[](RunFacts& f) { f.moves[0].shape[1] = ProfileShape::kTrapezoid; },
       "expect.profile: expected [triangle, triangle, triangle, triangle, triangle, triangle], got [triangle, "
       "trapezoid, triangle, triangle, triangle, triangle] (axis 2 differs: expected triangle, got trapezoid)"},
      {[](RunFacts& f) { f.peak_speed_deg_s[5] = 9.9998; },
       "expect.peak_speed_deg_s: expected [10, 10, 10, 10, 10, 10.0009] +-0.001, got [10, 10, 10, 10, 10, 9.9998] "
       "(axis 6 differs: expected 10.0009, got 9.9998, difference -0.0011)"},
      {[](RunFacts& f) { f.peak_pulses_per_tick = 10; }, "expect.peak_pulses_per_tick: expected 9, got 10"},
      {[](RunFacts& f) { f.underruns = 1; }, "expect.underruns: expected 0, got 1"},
      {[](RunFacts& f) { f.moves_waiting = 1, f.moves_under_way = 2; },
       "expect.unfinished_moves: expected 0, got 3: 1 waiting, 2 under way at the end"},
      {[](RunFacts& f) { f.moves[1].continues = false; }, "expect.blended_moves: expected 1, got 0"},
      {[](RunFacts& f) { f.held_s = 0.29; }, "expect.min_held_s: expected at least 0.3 s, got 0.29 s"},
      {[](RunFacts& f) { f.final_rotation->setIdentity(); },
       "expect.final_rpy_deg: expected [0, 0, 90.009] +-0.01, got [0, 0, 0], 90.009 deg away"},
      {[](RunFacts& f) { f.final_rotation.reset(); },
       "expect.final_rpy_deg: expected [0, 0, 90.009] +-0.01, got not measured"},
      {[](RunFacts& f) { f.path_error->mm = 0.051; },
       "expect.max_path_error_mm: expected at most 0.05 mm, got 0.051 mm in move[0] (tick 7, 0.000000 s)"},
      {[](RunFacts& f) { f.path_error.reset(); },
       "expect.max_path_error_mm: expected at most 0.05 mm, got no move on a line or an arc that was measured"},
      {[](RunFacts& f) { f.command_path_error->mm = 2e-6; },
       "expect.max_command_path_error_mm: expected at most 1e-06 mm, got 2e-06 mm in move[1] (tick 8, 0.000000 s)"},
      {[](RunFacts& f) { f.command_path_error->mm = std::numeric_limits<double>::quiet_NaN(); },
       "expect.max_command_path_error_mm: expected at most 1e-06 mm, got nan mm in move[1] (tick 8, 0.000000 s)"},
      {[](RunFacts& f) { f.peak_tool_speed_mm_s->value = 250.5; },
       "expect.max_tool_speed_mm_s: expected at most 250 mm/s, got 250.5 mm/s (tick 8, 0.000000 s)"},
      {[](RunFacts& f) { f.peak_tool_accel_mm_s2->value = 5001; },
       "expect.max_tool_accel_mm_s2: expected at most 5000 mm/s^2, got 5001 mm/s^2 (tick 9, 0.000000 s)"},
      {[](RunFacts& f) { f.peak_tool_accel_mm_s2.reset(); },
       "expect.max_tool_accel_mm_s2: expected at most 5000 mm/s^2, got none"},
      {[](RunFacts& f) { (*f.final_tcp_mm)[2] = 299.9999; },
       "expect.final_tcp_mm: expected [100, 200, 300.01] +-0.01, got [100, 200, 299.9999], 0.0101 mm away"},
      {[](RunFacts& f) { f.final_tcp_mm.reset(); },
       "expect.final_tcp_mm: expected [100, 200, 300.01] +-0.01, got not measured"},
      {[](RunFacts& f) { f.moves[1].stretch = 3.99; }, "expect.min_stretch: expected at least 4, got 3.99"},
      {[](RunFacts& f) { f.moves[1].stretch = 4.01; }, "expect.max_stretch: expected at most 4, got 4.01"},
      {[](RunFacts& f) { f.corrected_ticks = 49; }, "expect.min_corrected_ticks: expected at least 50, got 49"},
      {[](RunFacts& f) { f.corrected_ticks = 51; }, "expect.max_corrected_ticks: expected at most 50, got 51"},
      {[](RunFacts& f) { f.uncorrected_ticks = 3; }, "expect.min_uncorrected_ticks: expected at least 4, got 3"},
      {[](RunFacts& f) { f.uncorrected_ticks = 5; }, "expect.max_uncorrected_ticks: expected at most 4, got 5"},
      {[](RunFacts& f) { f.solved_poses = 99; }, "expect.min_solved_poses: expected at least 100, got 99"},
      {[](RunFacts& f) { f.solver_difference_pulses = 0.51; },
       "expect.max_solver_difference_pulses: expected at most 0.5 pulses, got 0.51 pulses"},
      {[](RunFacts& f) { f.moves[1].residual_rad = 0.008; },
       "expect.min_residual_deg: expected at least 0.5 deg, got 0.458366 deg"},
      {[](RunFacts& f) { f.moves[0].residual_rad = 0.011; },
       "expect.max_residual_deg: expected at most 0.6 deg, got 0.630254 deg"},
      {[](RunFacts& f) { f.settle_s = 0.0201; },
       "expect.settled_within_s: expected at most 0.02 s, got after 0.0201 s"},
      {[](RunFacts& f) { f.settle_s.reset(); },
       "expect.settled_within_s: expected at most 0.02 s, got never within 1 counts, at the end [0, 0, 1, 0, 0, 0]"},
      {[](RunFacts& f) { f.overshoot_counts[4] = 3; }, "expect.max_overshoot_counts: expected at most 2, got 3"},
      {[](RunFacts& f) { f.max_correction_pulses = 4; }, "expect.max_correction_pulses: expected at most 3, got 4"},
      {[](RunFacts& f) { f.inexact_ticks[0] = 6; },
       "expect.inexact_ticks: expected [7, 0, 0, 0, 0, 0], got [6, 0, 0, 0, 0, 0] (axis 1 differs: expected 7, got 6, "
       "difference -1)"},
      {[](RunFacts& f) { f.homings[1].ended.reset(); },
       "expect.homing_ends: expected [homed, no_index], got [no_index]"},
      {[](RunFacts& f) { (*f.final_load_deg)[1] = -0.052; },
       "expect.final_load_deg: expected [0, -0.05, 0, 0, 0, 0] +-0.001, got [0, -0.052, 0, 0, 0, 0] (axis 2 differs: "
       "expected -0.05, got -0.052, difference -0.002)"},
      {[](RunFacts& f) { (*f.lost_motion_deg)[3] = 0.1; },
       "expect.lost_motion_deg: expected [0, 0, 0, 0.08, 0, 0] +-0.01, got [0, 0, 0, 0.1, 0, 0] (axis 4 differs: "
       "expected 0.08, got 0.1, difference 0.02)"},
      {[](RunFacts& f) { f.max_residual_pulses = 6; }, "expect.max_residual_pulses: expected at most 5, got 6"},
      {[](RunFacts& f) { f.lost_counts[1] = -9; },
       "expect.lost_counts: expected [0, -8, 0, 0, 0, 0], got [0, -9, 0, 0, 0, 0] (axis 2 differs: expected -8, got "
       "-9, difference -1)"},
      {[](RunFacts& f) {
         f.faults.push_back({FaultCause::kEncoder, {.tick = 0, .at = Cycles{7}, .axis = 2}});
       },
       "expect.faults: expected [], got [encoder] (encoder of axis 2, 0.000000 s)"},
      {[](RunFacts& f) {
         f.bus_aborts = {{.core = 0,
                          .write = false,
                          .address = 0x43C2'0010,
                          .error = BusError::kSlaveError,
                          .where = {.tick = 3, .at = Cycles{50'000}}}};
       },
       "expect.bus_error: expected none, as it is not stated, got SLVERR (core 0, read at 0x43C20010, 0.001000 s)"},
      {[](RunFacts& f) { f.stopped_by = "estop"; },
       "expect.stopped_by: expected no stop, as it is not stated, got estop"},
      {[](RunFacts& f) {
         f.ticks = 3;
         f.first_trigger_at = RunPlace{.tick = 0, .at = Cycles{0}};
         f.last_trigger_at = RunPlace{.tick = 2, .at = Cycles{5'000}};
         f.cycles = Cycles{12'499};
       },
       "expect.missing_ticks: expected 0, as it is not stated, got 2 (the last trigger: tick 2, 0.000100 s)"},
      {[](RunFacts& f) {
         f.injected_faults = {{.spec = {.kind = Estop{.duration_s = 0.02}}, .when = {.tick = 3, .at = Cycles{50'000}}},
                              {.spec = {.kind = BlockHang{}}, .when = {}, .answered = true}};
       },
       "expect.unanswered_faults: expected 0, as it is not stated, got 1 (estop for 0.02 s, 0.001000 s)"},
      {[](RunFacts& f) {
         f.moves[1].unasked_stop = true;
         f.moves[1].tag = Tag{3};
         f.moves[1].start_tick = Ticks{400};
         f.first_trigger_at = RunPlace{.tick = 0, .at = Cycles{1'000}};
         f.ticks = 500;
       },
       "expect.unasked_stops: expected 0, as it is not stated, got 1 (before move[3], tick 400, 0.020020 s)"},
  };
  for (const Case& one : cases) {
    RunFacts facts = good_run();
    one.spoil(facts);
    EXPECT_THAT(texts(all_of_it(), facts, Where::kYes), ElementsAre(one.message));
  }
}

TEST(Expect, TheFirstBusErrorIsTheExpectedOne) {
  RunFacts facts = good_run();
  ExpectSpec expect = all_of_it();
  expect.bus_error = "SLVERR";
  EXPECT_THAT(texts(expect, facts), ElementsAre("expect.bus_error: expected SLVERR, got none"));
  facts.bus_aborts = {{.error = BusError::kSlaveError}, {.error = BusError::kTimeout}};
  EXPECT_THAT(texts(expect, facts), IsEmpty());
  expect.bus_error = "DECERR";
  EXPECT_THAT(texts(expect, facts), ElementsAre("expect.bus_error: expected DECERR, got SLVERR"));
}

TEST(Expect, AStatedNumberOfMissingTicksAndUnansweredFaultsIsMet) {
  RunFacts facts = good_run();
  facts.cycles = Cycles{6 * 2'500};  // no trigger at all
  facts.injected_faults = {{.spec = {.kind = Estop{.duration_s = 0.02}}, .when = {}}};
  ExpectSpec expect = all_of_it();
  expect.missing_ticks = 2;
  expect.unanswered_faults = 1;
  EXPECT_THAT(texts(expect, facts), IsEmpty());
  expect.missing_ticks = 1;
  expect.unanswered_faults = 0;
  EXPECT_THAT(texts(expect, facts),
              ElementsAre("expect.missing_ticks: expected 1, got 2", "expect.unanswered_faults: expected 0, got 1"));
}

TEST(Expect, TheLongestTimeToAStopIsComparedAndItsFaultNamed) {
  RunFacts facts = good_run();
  facts.injected_faults = {
      {.spec = {.kind = Estop{.duration_s = 0.02}}, .when = {}, .servo_off = Cycles{2'500}, .answered = true},
      {.spec = {.kind = DriveAlarm{.axis = 2, .duration_s = 1}},
       .when = {.tick = 3, .at = Cycles{50'000}},
       .servo_off = Cycles{60'001},
       .answered = true},
      {.spec = {.kind = BlockHang{}}, .when = {}, .answered = true}};
  ExpectSpec expect = all_of_it();
  expect.max_stop_ticks = 5;
  EXPECT_THAT(texts(expect, facts), IsEmpty());
  expect.max_stop_ticks = 4;
  EXPECT_THAT(texts(expect, facts, Where::kYes),
              ElementsAre("expect.max_stop_ticks: expected at most 4, got 5 (drive_alarm of axis 2 for 1 s, "
                          "0.001000 s)"));
  EXPECT_THAT(texts(expect, good_run()), ElementsAre("expect.max_stop_ticks: expected at most 4, got no stop"));
}

TEST(Expect, AStatedNumberOfUnaskedStopsIsMetAndTheFirstAreNamed) {
  RunFacts facts = good_run();
  facts.moves.resize(8);
  for (std::size_t i = 1; i < facts.moves.size(); ++i) {
    facts.moves[i] = {
        .tag = static_cast<std::uint32_t>(i), .start_tick = Ticks{10 * static_cast<int>(i)}, .unasked_stop = true};
  }
  ExpectSpec expect;
  expect.unasked_stops = 7;
  EXPECT_THAT(texts(expect, facts), IsEmpty());
  expect.unasked_stops = 6;
  EXPECT_THAT(texts(expect, facts, Where::kYes),
              ElementsAre("expect.unasked_stops: expected 6, got 7 (before move[1], tick 10; before move[2], tick 20; "
                          "before move[3], tick 30; before move[4], tick 40; before move[5], tick 50; and 2 more)"));
}

TEST(Expect, RefusalsAreNamedInTheirOrder) {
  RunFacts facts = good_run();
  facts.refusals.push_back({{.reason = Refusal::kUnreachable}, Cycles{0}});
  facts.refusals.push_back({{.reason = Refusal::kChainRefused}, Cycles{1}});
  EXPECT_THAT(texts(all_of_it(), facts),
              ElementsAre("expect.refused_moves: expected 0, got 2: unreachable, chain_refused",
                          "expect.refusals: expected [], got [unreachable, chain_refused]"));
  ExpectSpec expect;
  expect.refusals = {"chain_refused", "unreachable"};
  EXPECT_THAT(texts(expect, facts), ElementsAre("expect.refusals: expected [chain_refused, unreachable], got "
                                                "[unreachable, chain_refused]"));
  expect.refusals = {"unreachable", "chain_refused"};
  EXPECT_THAT(texts(expect, facts), IsEmpty());
}

TEST(Expect, JudgesOnlyTheAxesThatTheRobotHas) {
  RunFacts facts = good_run();
  facts.axis_count = 5;
  facts.total_pulses[5] = 7;
  ExpectSpec expect;
  expect.total_pulses = PerAxis<std::int64_t>{10, 20, 30, 40, 51, 0};
  expect.profile = std::vector<std::string>(5, "triangle");
  EXPECT_THAT(texts(expect, facts),
              ElementsAre("expect.total_pulses: expected [10, 20, 30, 40, 51], got [10, 20, 30, 40, 50]"));
}

TEST(Expect, WhatIsNotMentionedMustNotHappen) {
  EXPECT_THAT(texts({}, good_run()), IsEmpty());
  RunFacts facts = good_run();
  facts.end_fault = FaultCause::kWatchdog;
  facts.underruns = 4;
  facts.stopped_by = "watchdog";
  facts.refusals.push_back({{.reason = Refusal::kOutsideLimits, .axis = 2}, Cycles{0}});
  EXPECT_THAT(texts({}, facts),
              ElementsAre("expect.outcome: expected completed, got fault:watchdog",
                          "expect.refused_moves: expected 0, as it is not stated, got 1: outside_limits",
                          "expect.underruns: expected 0, as it is not stated, got 4",
                          "expect.stopped_by: expected no stop, as it is not stated, got watchdog"));
}

RunFacts watchdog_run() {
  RunFacts facts = good_run();
  facts.end_fault = FaultCause::kWatchdog;
  facts.faults.push_back({FaultCause::kWatchdog, {.tick = 0, .at = Cycles{1000}, .axis = 0}});
  facts.underruns = 5;
  facts.stopped_by = "watchdog";
  return facts;
}

TEST(Expect, AnExpectedFaultExcusesTheStopAndNothingElse) {
  RunFacts facts = watchdog_run();
  ExpectSpec expect;
  expect.outcome = "fault:watchdog";
  EXPECT_THAT(texts(expect, facts), ElementsAre("expect.underruns: expected 0, as it is not stated, got 5"));
  expect.underruns = 5;
  EXPECT_THAT(texts(expect, facts), IsEmpty());
  facts.refusals.push_back({{.reason = Refusal::kNotReady}, Cycles{0}});
  EXPECT_THAT(texts(expect, facts),
              ElementsAre("expect.refused_moves: expected 0, as it is not stated, got 1: not_ready"));
}

TEST(Expect, AFaultThatWasClearedMustBeMentioned) {
  RunFacts facts = good_run();
  facts.faults = {{FaultCause::kEstop, {.tick = 0, .at = Cycles{1}, .axis = 0}},
                  {FaultCause::kDriveAlarm, {.tick = 0, .at = Cycles{2}, .axis = 4}}};
  facts.stopped_by = "drive_alarm";
  ExpectSpec expect;
  expect.stopped_by = "drive_alarm";
  EXPECT_THAT(texts(expect, facts), ElementsAre("expect.faults: expected only the stated ones, got also [estop]"));
  expect.faults = {"drive_alarm", "estop"};
  EXPECT_THAT(texts(expect, facts),
              ElementsAre("expect.faults: expected [drive_alarm, estop], got [estop, drive_alarm]"));
  expect.faults = {"estop", "drive_alarm"};
  EXPECT_THAT(texts(expect, facts), IsEmpty());
  expect.stopped_by.reset();  // the list says it all
  EXPECT_THAT(texts(expect, facts), IsEmpty());
  EXPECT_THAT(texts({}, facts),
              ElementsAre("expect.faults: expected only the stated ones, got also [estop, drive_alarm]",
                          "expect.stopped_by: expected no stop, as it is not stated, got drive_alarm"));
}

TEST(Expect, AStopThatTheControllerMissedIsNoCompletedRun) {
  RunFacts facts = good_run();
  facts.controller_silent = true;
  facts.stopped_by = "controller_silent";
  EXPECT_THAT(texts({}, facts),
              ElementsAre("expect.outcome: expected completed, got fault:controller_silent",
                          "expect.stopped_by: expected no stop, as it is not stated, got controller_silent"));
  ExpectSpec expect;
  expect.outcome = "fault:controller_silent";
  EXPECT_THAT(texts(expect, facts), IsEmpty());
}

TEST(Expect, AnExpectedFaultIsJudgedOnWhatItStates) {
  const RunFacts facts = watchdog_run();
  ExpectSpec expect;
  expect.outcome = "fault:watchdog";
  expect.min_underruns = 5;
  expect.stopped_by = "watchdog";
  EXPECT_THAT(texts(expect, facts), IsEmpty());
  expect.min_underruns = 6;
  expect.stopped_by = "estop";
  EXPECT_THAT(texts(expect, facts), ElementsAre("expect.min_underruns: expected at least 6, got 5",
                                                "expect.stopped_by: expected estop, got watchdog"));
  expect = {};
  expect.outcome = "fault:encoder";
  expect.underruns = 5;
  EXPECT_THAT(texts(expect, facts), ElementsAre("expect.outcome: expected fault:encoder, got fault:watchdog"));
}

}  // namespace
}  // namespace armature::cosim
