// The search of corners between paths and joint moves takes time on core 1, which executes commands meanwhile.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "controller/trajectory/plan/corner_planner.hpp"
#include "tests/controller/support/corner_judge.hpp"

namespace armature {
namespace {

using test::beside;
using test::degrees;
using test::joint;
using test::kThere;
using test::kTripSecond;
using test::line;
using test::Trip;

std::vector<Command> pick_and_place() {
  return {line({0, 0, -60}, 5, 1), joint({40, 0, 5, 0, 0, 0}, 3, 2), line({0, 0, 60}, 0, 3)};
}

double charged_ms(Work work, std::int64_t times) {
  return (work == Work::kRetarget ? 0.0144 : 0.007) * static_cast<double>(times);
}

// A corner is searched with joint plans and kinematics, which both take time on core 1. `Work::kRetarget` is charged
// for nothing else.
TEST(PathJointCornerSearch, TheSearchOfCornersIsChargedInShortSteps) {
  Trip run;
  std::int64_t inverses = 0, retargets = 0;
  int passages = 0, steps = 0;
  double corners_ms = 0.0;
  run.rig->on_core1_work = [&](Work work, std::int64_t times) {
    if (work == Work::kInverse) inverses = times;
    if (work == Work::kPlan) inverses = 0;
    if (work != Work::kRetarget) return;
    EXPECT_LE(inverses, kMaxOfStep.inverses);
    EXPECT_LE(times, kMaxOfStep.retargets);
    corners_ms += charged_ms(Work::kInverse, inverses) + charged_ms(work, times);
    ++steps;
    passages += times > 1 ? 1 : 0;
    retargets += times;
    inverses = 0;
  };
  for (const Command& command : pick_and_place()) run.rig->submit_at(kThere, command);
  run.rig->run(kThere + kTripSecond / 2);
  EXPECT_GT(steps, 10);
  EXPECT_GT(passages, 5);
  EXPECT_GT(retargets, steps);
  EXPECT_GT(corners_ms, 1.0);
  EXPECT_LT(corners_ms, 20.0);
  RecordProperty("corners_ms", std::to_string(corners_ms));
}

// Wherever they come while corners are searched, they do not wait longer than for a step.
TEST(PathJointCornerSearch, StopsAndNewTargetsAreAcceptedWithinAStep) {
  const double most_ms = charged_ms(Work::kInverse, kMaxOfStep.inverses);
  std::int64_t charges = 0;
  double longest_ms = 0.0;
  for (std::int64_t at = 0; at <= charges; at += 3) {
    Command interruption = Stop{};
    if (at % 2 == 1) interruption = JointMove{.target = degrees(beside({5, 0, 0, 0, 0, 0})), .now = true, .tag = 4};
    Trip run;
    std::int64_t count = 0;  // of charges since the search of the first corner began
    double waited_ms = 0.0;
    run.rig->on_core1_work = [&](Work work, std::int64_t times) {
      if (work == Work::kPlan || (count == 0 && work != Work::kRetarget)) return;
      ++count;
      if (at == 0) charges = count;  // uninterrupted
      if (at == count) run.rig->submit(interruption);
      if (at > 0 && count >= at) waited_ms += charged_ms(work, times);
    };
    for (const Command& command : pick_and_place()) run.rig->submit_at(kThere, command);
    run.rig->run(kThere + 200);
    longest_ms = std::max(longest_ms, waited_ms);
    EXPECT_LE(waited_ms, most_ms) << "interrupted at charge " << at;
    if (at > 0) {
      EXPECT_EQ(run.rig->refusals.size(), 3u) << "interrupted at charge " << at;
    }
  }
  EXPECT_GT(charges, 20);
  EXPECT_GT(longest_ms, 0.1);
  RecordProperty("longest_ms", std::to_string(longest_ms));
}

}  // namespace
}  // namespace armature
