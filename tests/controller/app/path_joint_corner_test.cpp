// Corners between paths of the tool and joint moves, judged by their set-points.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/controller/support/corner_judge.hpp"

namespace armature {
namespace {

using test::beside;
using test::Corner;
using test::degrees;
using test::entry_of;
using test::exit_of;
using test::expect_limits;
using test::joint;
using test::kDeg;
using test::kPostureDeg;
using test::kThere;
using test::kTripSecond;
using test::line;
using test::slowest_step;
using test::Trip;

TEST(PathJointCorner, PassesFromALineToAJointMoveWithinTheDeviation) {
  const Trip run{{line({0, 80, 0}, 4.0, 1), joint({30, -10, 0, 0, 10, 0}, 0, 2)}};
  const Trip stopped{{line({0, 80, 0}, 0.0, 1), joint({30, -10, 0, 0, 10, 0}, 0, 2)}};
  ASSERT_EQ(run.moves().size(), 2u);
  EXPECT_TRUE(run.moves()[1].continues);
  EXPECT_FALSE(stopped.moves()[1].continues);
  EXPECT_TRUE(run.rig->refusals.empty());
  EXPECT_EQ(run.rig->moves_finished(), 3);
  const Corner corner = exit_of(run, 0);
  EXPECT_LE(corner.missed, 4.0);
  EXPECT_GT(corner.missed, 3.9);  // used fully
  EXPECT_LE(corner.left, 4.0 * 1.01);
  EXPECT_GT(slowest_step(run, run.started(0) + 400, run.ended(1) - 400), 1e-5);
  EXPECT_LT(run.taken() + 100, stopped.taken());
  run.rig->expect_at(beside({30, -10, 0, 0, 10, 0}));
  run.rig->expect_pulses_conserved();
  expect_limits(run, false, "line to joint");
}

TEST(PathJointCorner, PassesFromAJointMoveToALineWithinTheDeviation) {
  const Trip run{{joint({30, -10, 0, 0, 10, 0}, 2.0, 1), line({0, -80, 0}, 0.0, 2)}};
  const Trip stopped{{joint({30, -10, 0, 0, 10, 0}, 0, 1), line({0, -80, 0}, 0.0, 2)}};
  ASSERT_EQ(run.moves().size(), 2u);
  EXPECT_TRUE(run.moves()[1].continues);
  const Corner corner = entry_of(run, 0, stopped);
  EXPECT_LE(corner.missed, 2.0 * kDeg);
  EXPECT_GT(corner.missed, 1.9 * kDeg);
  EXPECT_LE(corner.left, 2.0 * kDeg * 1.01);
  EXPECT_GT(slowest_step(run, run.started(0) + 400, run.ended(1) - 400), 1e-5);
  EXPECT_LT(run.taken() + 100, stopped.taken());
  EXPECT_EQ(run.rig->last().reference, stopped.rig->last().reference);
  run.rig->expect_pulses_conserved();
  expect_limits(run, false, "joint to line");
}

TEST(PathJointCorner, JoinsPickAndPlaceIntoOneMotion) {
  const auto commands = [](double mm, double deg) {
    return std::vector<Command>{line({0, 0, -60}, mm, 1), joint({40, 0, 5, 0, 0, 0}, deg, 2), line({0, 0, 60}, 0, 3)};
  };
  const Trip run{commands(5, 3)}, stopped{commands(0, 0)};
  ASSERT_EQ(run.moves().size(), 3u);
  EXPECT_TRUE(run.moves()[1].continues);
  EXPECT_TRUE(run.moves()[2].continues);
  EXPECT_LE(exit_of(run, 0).missed, 5.0);
  EXPECT_LE(entry_of(run, 1, stopped).missed, 3 * kDeg);
  EXPECT_GT(slowest_step(run, run.started(0) + 400, run.ended(2) - 400), 1e-5);
  EXPECT_LT(run.taken() + 1'000, stopped.taken());
  EXPECT_EQ(run.rig->last().reference, stopped.rig->last().reference);
  expect_limits(run, false, "line, joint, line");
}

TEST(PathJointCorner, JoinsAtMostThreePartsAndStopsThen) {
  std::vector<Command> commands;
  for (std::uint32_t i = 0; i < 4; ++i) {
    commands.push_back(line({0, i % 2 == 0 ? 60.0 : -60.0, 0}, 4, 2 * i + 1));
    commands.push_back(joint({i % 2 == 0 ? 30.0 : 0.0, 0, 0, 0, 10, 0}, 3, 2 * i + 2));
  }
  const Trip run{commands, 4 * kTripSecond};
  ASSERT_EQ(run.moves().size(), 8u);
  EXPECT_EQ(run.rig->moves_finished(), 9);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(run.moves()[i].continues, i % 3 != 0) << i;
  expect_limits(run, false, "eight moves");
}

TEST(PathJointCorner, JoinsChainsOfBothKinds) {
  const std::vector<Command> commands{
      joint({20, 0, 0, 0, 0, 0}, 3, 1), joint({20, 10, 0, 0, 0, 0}, 3, 2), line({0, 50, 0}, 3, 3),
      line({50, 0, 0}, 3, 4),           joint({0, -10, 5, 0, 0, 0}, 3, 5), joint({-20, 0, 0, 0, 0, 0}, 0, 6)};
  const Trip run{commands};
  ASSERT_EQ(run.moves().size(), 6u);
  for (std::size_t i = 1; i < 6; ++i) EXPECT_TRUE(run.moves()[i].continues) << i;
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(run.moves()[i].tag.number(), i + 1);
    EXPECT_EQ(run.rig->finished[i + 1].tag.number(), i + 1);
  }
  run.rig->expect_at(beside({-20, 0, 0, 0, 0, 0}));
  run.rig->expect_pulses_conserved();
  expect_limits(run, false, "both chains");
}

TEST(PathJointCorner, StopsExactlyWithoutABlendOrAFollowerInTime) {
  for (int kind = 0; kind < 5; ++kind) {
    for (const bool path_first : {false, true}) {
      Trip run;
      const double mm = kind == 0 ? 0.0 : 4.0, deg = kind == 0 ? 0.0 : 3.0;
      const Command a = path_first ? Command{line({0, 60, 0}, mm, 1)} : Command{joint({20, 0, 0, 0, 0, 0}, deg, 1)};
      const Command b = path_first ? Command{joint({20, 0, 0, 0, 0, 0}, 0, 2)} : Command{line({0, 60, 0}, 0, 2)};
      run.rig->submit_at(kThere, a);
      if (kind == 1) run.rig->submit_at(kThere, SetOutput{.pin = 1, .level = true});
      if (kind == 2) run.rig->submit_at(kThere, joint({900, 0, 0, 0, 0, 0}, 0, 3));  // refused at once
      if (kind == 3) run.rig->submit_at(kThere, line({0, 9'000, 0}, 0, 3));          // refused when planned
      run.rig->submit_at(kind == 4 ? kThere + 4'000 : kThere, b);
      run.rig->run(kThere + 2 * kTripSecond);
      const std::string what = "kind " + std::to_string(kind) + (path_first ? " path first" : " joint first");
      // The line that is refused and the other line are one chain.
      ASSERT_EQ(run.moves().size(), kind == 3 ? 1u : 2u) << what;
      for (const MoveStarted& move : run.moves()) EXPECT_FALSE(move.continues) << what;
      EXPECT_EQ(run.rig->moves_finished(), static_cast<std::int64_t>(run.rig->moves.size())) << what;
      expect_limits(run, false, what);
      if (HasFatalFailure()) return;
    }
  }
}

// A pose out of reach after the path: the path is executed to its end.
TEST(PathJointCorner, AFollowerThatIsRefusedLeavesThePathAsItIs) {
  Trip run;
  run.rig->submit_at(kThere, line({0, 60, 0}, 4, 1));
  run.rig->submit_at(kThere, PoseMove{.target = {.position_mm = {5'000, 0, 0}}, .tag = 2});
  run.rig->submit_at(kThere, joint({0, 10, 0, 0, 0, 0}, 0, 3));
  run.rig->run(kThere + 3 * kTripSecond);
  ASSERT_EQ(run.rig->refusals.size(), 1u);
  EXPECT_EQ(run.rig->refusals[0].tag.number(), 2u);
  ASSERT_EQ(run.moves().size(), 2u);
  EXPECT_FALSE(run.moves()[1].continues);
  run.rig->expect_at(beside({0, 10, 0, 0, 0, 0}));
}

TEST(PathJointCorner, AStopDropsWhatIsNotSentYet) {
  Trip run;
  bool stopped = false;
  run.rig->on_core1_work = [&](Work work, std::int64_t) {
    if (work != Work::kRetarget || stopped) return;
    stopped = true;
    run.rig->submit(Stop{});
  };
  run.rig->submit_at(kThere, line({0, 0, -60}, 6, 1));
  run.rig->submit_at(kThere, joint({40, 0, 5, 0, 0, 0}, 4, 2));
  run.rig->submit_at(kThere, line({0, 0, 60}, 0, 3));
  run.rig->run(kThere + kTripSecond);
  EXPECT_TRUE(stopped);
  ASSERT_EQ(run.rig->refusals.size(), 3u);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(run.rig->refusals[i].tag.number(), i + 1);
  run.rig->expect_at(kPostureDeg);
}

// Windows are never joined: the arm stops in the corner, and the lines continue as windows. The output is not switched
// during the hold, so all moves of the shorter chains wait together behind it.
void expect_corners_with_stops(std::uint32_t lines) {
  for (const bool path_before : {false, true}) {
    std::vector<Command> commands{SetOutput{.pin = 1, .level = true}};
    std::uint32_t tag = 1;
    if (path_before) commands.emplace_back(line({0, 0, 40}, 4, tag++));
    commands.emplace_back(joint({20, 0, 0, 0, 0, 0}, 3, tag++));
    const std::uint32_t first = tag;
    for (std::uint32_t i = 0; i < lines; ++i) commands.emplace_back(line({0, 1.5, 0}, 1, tag++));
    commands.emplace_back(joint({0, 10, 0, 0, 0, 0}, 0, tag++));
    Trip run;
    run.rig->submit_at(kThere - 10, Hold{});
    run.rig->submit_at(kThere + 10, Resume{});
    std::size_t fed = 0;
    run.rig->on_each_trigger = [&] {
      if (run.rig->logic.triggers() < kThere) return;
      while (fed < commands.size() && run.rig->submit_program(commands[fed])) ++fed;
    };
    run.rig->run(kThere + 3 * kTripSecond);
    const std::string what = std::string(path_before ? "line, joint, " : "joint, ") + std::to_string(lines) + " lines";
    EXPECT_TRUE(run.rig->refusals.empty()) << what;
    ASSERT_EQ(run.moves().size(), tag - 1) << what;
    EXPECT_EQ(run.rig->finished.size(), tag) << what;
    for (std::uint32_t i = 1; i < tag; ++i) {
      const bool is_corner = i == first || i + 1 == tag;
      EXPECT_EQ(run.moves()[i - 1].continues, i > 1 && !is_corner) << what << " move " << i;
    }
    run.rig->expect_at(beside({0, 10, 0, 0, 0, 0}));
    run.rig->expect_pulses_conserved();
    expect_limits(run, false, what);
  }
}

TEST(PathJointCorner, ALongChainOfLinesIsNotJoined) {
  for (const std::uint32_t lines : {16u, 20u, 40u}) expect_corners_with_stops(lines);
}

// Each group of three moves is one plan, which takes two of the nine entries of the queue.
std::vector<Command> groups_of_three(std::uint32_t count, bool path_first) {
  std::vector<Command> commands;
  std::uint32_t tag = 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    const JointMove there = joint({i % 2 == 0 ? 15.0 : 0.0, 0, 0, 0, 0, 0}, path_first ? 3 : 0, 0);
    const JointMove back = joint({i % 2 == 0 ? 15.0 : 0.0, i % 2 == 0 ? 0.0 : 5.0, 0, 0, 0, 0}, 3, 0);
    const auto add = [&](auto move) {
      move.tag = tag++;
      commands.emplace_back(move);
    };
    if (path_first) {
      add(line({0, 0, -50}, 4, 0));
      add(there);
      add(line({0, 0, 50}, 0, 0));
    } else {
      add(back);
      add(line({0, 0, -50}, 4, 0));
      add(there);
    }
  }
  return commands;
}

void submit_in_portions(Trip& run, const std::vector<Command>& commands) {
  for (std::size_t i = 0; i < commands.size(); ++i) {
    run.rig->submit_at(kThere + 1'200 * static_cast<std::int64_t>(i / 12), commands[i]);
  }
}

TEST(PathJointCorner, MorePlansOfThreePartsThanTheQueueHoldsFollowEachOther) {
  for (const bool path_first : {true, false}) {
    Trip run;
    submit_in_portions(run, groups_of_three(9, path_first));
    run.rig->run(kThere + 8 * kTripSecond);
    const std::string what = path_first ? "line, joint, line" : "joint, line, joint";
    EXPECT_TRUE(run.rig->refusals.empty()) << what;
    ASSERT_EQ(run.moves().size(), 27u) << what;
    ASSERT_EQ(run.rig->finished.size(), 28u) << what;
    for (std::size_t i = 0; i < 27; ++i) {
      EXPECT_EQ(run.moves()[i].tag.number(), i + 1) << what;
      EXPECT_EQ(run.rig->finished[i + 1].tag.number(), i + 1) << what;
      EXPECT_EQ(run.moves()[i].continues, i % 3 != 0) << what << " move " << i + 1;
    }
    run.rig->expect_pulses_conserved();
    expect_limits(run, false, what);
  }
}

TEST(PathJointCorner, AStopOrANewTargetDropsWaitingPlansOfThreeParts) {
  for (const bool stop : {true, false}) {
    for (const std::int64_t at : {kThere + 1'000, kThere + 9'000}) {
      Trip run;
      submit_in_portions(run, groups_of_three(6, true));
      if (stop) {
        run.rig->submit_at(at, Stop{});
      } else {
        run.rig->submit_at(at, JointMove{.target = degrees(kPostureDeg), .now = true, .tag = 90});
      }
      const std::vector<Command> after{line({0, 0, -50}, 4, 91), joint({15, 0, 0, 0, 0, 0}, 3, 92),
                                       line({0, 0, 50}, 0, 93)};
      for (const Command& command : after) run.rig->submit_at(at + kTripSecond, command);
      run.rig->run(at + 3 * kTripSecond);
      const std::string what = (stop ? "stop at " : "new target at ") + std::to_string(at);
      // Every move is reported once, and the queue is free for three parts.
      const std::size_t submitted = std::size_t{18} + (stop ? 0 : 1) + after.size();
      EXPECT_EQ(run.moves().size() + run.rig->refusals.size(), submitted) << what;
      EXPECT_GT(run.rig->refusals.size(), 6u) << what;
      EXPECT_EQ(run.rig->moves.size(), run.rig->finished.size()) << what;
      ASSERT_GE(run.moves().size(), 3u) << what;
      const std::vector<MoveStarted> moves = run.moves();
      EXPECT_EQ(moves.back().tag.number(), 93u) << what;
      EXPECT_EQ(moves.back().continues && moves[moves.size() - 2].continues, true) << what;
      run.rig->expect_pulses_conserved();
      expect_limits(run, false, what);
    }
  }
}

}  // namespace
}  // namespace armature
