// Thousands of random moves of every arm of the project: what the planner accepts keeps every limit, stays on its path
// and on its branch and ends where it was asked to, at ticks, between ticks, and under holds, overrides and stops.
//
// ARMATURE_CAMPAIGN=<n> in the environment drives n times as many chains, with other seeds.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <ostream>
#include <string>

#include "controller/trajectory/run/sampler.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/keeping_sampler.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random_chains.hpp"
#include "tests/controller/support/robot_files.hpp"
#include "tests/controller/support/set_point_judge.hpp"

namespace armature {
namespace {

using test::Begin;
using test::Laws;
using test::PathRig;
using test::Random;
using test::RandomChain;
using test::SetPointJudge;
using Progress = CartesianPlanner::Progress;

constexpr std::uint64_t kCampaignSeed = 7'000;
// Set-points that may be planned for one chain; longer ones are left out, to drive more short ones.
constexpr std::size_t kMaxSamples = 50'000;
constexpr std::int64_t kLongest = 4'000;
// Limits are kept to the plan's own margin where the rate does not change, otherwise to rounding.
constexpr double kCampaignRounding = 2e-6;

// Chains that begin anywhere are the ones that are most often driven to their end.
int chains(Begin begin) {
  return begin == Begin::kAnywhere ? 300 : 400;
}

int times_as_many() {
  const char* times = std::getenv("ARMATURE_CAMPAIGN");
  return times == nullptr ? 1 : std::max(1, std::atoi(times));
}

struct Tally {
  int accepted = 0, stretched = 0, blended = 0, through_wrist = 0, left_out = 0;
  int at_rates = 0, standstills = 0, stops = 0;
  std::array<int, 10> refused{};  // by PathProblem::Kind
};

class Campaign {
 public:
  // Each chain has a seed of its own, so that one can be driven again alone.
  void drive(std::uint64_t seed, const RobotModel& robot, Laws laws, bool blended, Begin begin) {
    random_ = Random{seed};
    const RandomChain chain = test::ChainMaker{random_, robot, laws, blended, begin}.make();
    PathRig rig{chain.robot, 20.0, chain.tool};
    rig.planner.begin(chain.start, chain.requests);
    const Progress progress = rig.planner.work(kMaxSamples);
    if (progress == Progress::kRefused) {
      ++tally.refused[static_cast<std::size_t>(rig.planner.problem().kind)];
      return;
    }
    if (progress == Progress::kWorking || rig.planner.plan().duration.value() > kLongest) {
      ++tally.left_out;
      return;
    }
    ++tally.accepted;
    count(rig.planner.plan());
    judge(chain, rig, laws == Laws::kSCurves);
  }

  Tally tally;

 private:
  void count(const CartesianPlan& plan) {
    bool stretched = false, blended = false;
    for (std::size_t i = 0; i < plan.count; ++i) {
      const CartesianSegment& segment = plan.segments[i];
      stretched = stretched || segment.stretch > 1.0;
      blended = blended || (i > 0 && segment.start < end_of(plan.segments[i - 1]));
    }
    tally.stretched += stretched ? 1 : 0;
    tally.blended += blended ? 1 : 0;
  }

  void judge(const RandomChain& chain, const PathRig& rig, bool with_jerk) {
    const SetPointJudge judge{chain, rig.arm};
    const std::vector<JointAngles> joints = rig.set_points();
    {
      SCOPED_TRACE("at ticks");
      ASSERT_EQ(judge.judge(joints, {.with_jerk = with_jerk}), "");
      ASSERT_EQ(judge.end(joints.back()), "");
    }
    const double sine = rig.arm.wrist_sine(joints.front());
    tally.through_wrist += sine * rig.arm.wrist_sine(joints.back()) < 0.0 ? 1 : 0;
    if (random_.integer(0, 1) == 0) {
      const double shift = random_.real(0.0, 1.0);
      SCOPED_TRACE("shifted by " + std::to_string(shift));
      ASSERT_EQ(judge.judge(rig.set_points(shift), {.with_jerk = with_jerk}), "");
    } else {
      SCOPED_TRACE("at random rates");
      drive_at_rates(chain, rig, judge);
    }
  }

  // A constant rate, or one that changes again and again, or a stop.
  void drive_at_rates(const RandomChain& chain, const PathRig& rig, const SetPointJudge& judge) {
    const CartesianPlan& plan = rig.planner.plan();
    const std::int64_t kind = random_.integer(0, 3);
    double wanted = kind == 0 ? random_.real(0.2, 1.0) : 1.0;
    test::KeepingSampler sampler{chain.robot, rig.arm, plan.start};
    sampler.start(plan, wanted);
    std::vector<JointAngles> joints(4, plan.start);
    const std::int64_t every = random_.integer(1, 1 + plan.duration.value() / 2);
    std::int64_t change = random_.integer(0, every), stop = kind == 1 ? change : -1;
    std::int64_t tick = 0;
    for (; sampler.busy() && (stop < 0 || tick <= stop || sampler.rate() > 0.0); ++tick) {
      if (kind >= 2 && tick == change) {
        const double slow = random_.real(0.05, 1.0);
        const std::array<double, 3> choices{0.0, 1.0, slow};
        wanted = tick > 3 * kLongest ? 1.0 : choices[static_cast<std::size_t>(random_.integer(0, 2))];
        change += random_.integer(1, every);
      }
      joints.push_back(stop >= 0 && tick >= stop ? sampler.brake() : sampler.advance(wanted));
      ASSERT_LE(sampler.inverses(), Sampler::kMaxInverses);
      tally.standstills += sampler.busy() && sampler.rate() == 0.0 ? 1 : 0;
      ASSERT_LT(tick, 15 * kLongest) << "does not end";
    }
    ++tally.at_rates;
    tally.stops += sampler.busy() ? 1 : 0;
    if (!sampler.busy()) {
      ASSERT_EQ(joints.back(), plan.target);
    }
    joints.insert(joints.end(), 4, joints.back());
    ASSERT_EQ(judge.judge(joints, {.slack = kCampaignRounding, .with_tool = stop < 0, .to_the_end = !sampler.busy()}),
              "");
  }

  Random random_{0};
};

// The fewest of each kind that must occur, about 70 % of what does: a planner that refuses more than it has to, or
// chains that stop meeting what they are for, show here.
struct Floors {
  int accepted, stretched, blended, at_rates, standstills, stops, through_wrist;
  int outside_limits, orientation, too_fast;  // refused
};

struct Part {
  const char* robot;
  Begin begin;
  Floors floors;
};

std::string name_of(const Part& part) {
  constexpr std::array kBegins{"anywhere", "near_limits", "near_wrist"};
  return std::string{part.robot} + "_" + kBegins[static_cast<std::size_t>(part.begin)];
}
void PrintTo(const Part& part, std::ostream* out) {
  *out << name_of(part);
}

class CartesianCampaign : public testing::TestWithParam<Part> {};

TEST_P(CartesianCampaign, WhatIsAcceptedKeepsLimitsPathBranchAndEnd) {
  const auto [name, begin, floors] = GetParam();
  const RobotModel robot = test::robot_of_file(name);
  const bool six = robot.arm.family == ArmFamily::kSixR;
  const int count = test::draws(times_as_many() * chains(begin));
  Campaign campaign;
  for (int draw = 0; draw < count; ++draw) {
    const std::uint64_t seed = kCampaignSeed + static_cast<std::uint64_t>(draw);
    SCOPED_TRACE("seed " + std::to_string(seed));
    campaign.drive(seed, robot, static_cast<Laws>(draw % 3), draw % 2 == 0, begin);
    if (HasFatalFailure()) return;
  }
  const Tally& tally = campaign.tally;
  const auto refused = [&](PathProblem::Kind kind) { return tally.refused[static_cast<std::size_t>(kind)]; };
  using Kind = PathProblem::Kind;
  RecordProperty("accepted", tally.accepted);
  RecordProperty("stretched", tally.stretched);
  RecordProperty("blended", tally.blended);
  RecordProperty("through_wrist", tally.through_wrist);
  RecordProperty("left_out", tally.left_out);
  RecordProperty("at_rates", tally.at_rates);
  RecordProperty("standstills", tally.standstills);
  RecordProperty("stops", tally.stops);
  for (std::size_t kind = 0; kind < tally.refused.size(); ++kind) {
    RecordProperty("refused_" + std::to_string(kind), tally.refused[kind]);
  }
  int sum = tally.accepted + tally.left_out;
  for (const Kind kind : {Kind::kNoCircle, Kind::kUnreachable, Kind::kOutsideLimits, Kind::kTooFast})
    sum += refused(kind);
  if (!six) sum += refused(Kind::kOrientation);
  EXPECT_EQ(sum, count) << "refused for another reason" << testing::PrintToString(tally.refused);
  EXPECT_LE(tally.left_out, count / 2);
  EXPECT_GE(tally.accepted, test::least(floors.accepted));
  EXPECT_GE(tally.stretched, test::least(floors.stretched));
  EXPECT_GE(tally.blended, test::least(floors.blended));
  EXPECT_GE(tally.at_rates, test::least(floors.at_rates));
  if (!test::few_draws()) {  // many in a few draws
    EXPECT_GE(tally.standstills, floors.standstills);
  }
  EXPECT_GE(tally.stops, test::least(floors.stops));
  EXPECT_GE(tally.through_wrist, test::least(floors.through_wrist));
  EXPECT_GE(refused(Kind::kOutsideLimits), test::least(floors.outside_limits));
  EXPECT_GE(refused(Kind::kOrientation), test::least(floors.orientation));
  EXPECT_GE(refused(Kind::kTooFast), test::least(floors.too_fast));
}

// A hold or an override shifts the set-points between the ticks by any part of a tick. Where a corner is passed within
// a tick, only some of these shifts show its acceleration.
TEST(CartesianCampaignBetweenTicks, LimitsAreKeptAtEveryShift) {
  constexpr int kShifts = 10;
  const RobotModel robot = test::robot_of_file("kuka_kr6_r900");
  const int count = test::draws(times_as_many() * 100);
  int corners_within_tick = 0;
  for (int draw = 0; draw < count; ++draw) {
    // Seed 7044 exceeded an acceleration by 2 % when only single jumps of the law counted as kinks.
    const std::uint64_t seed = kCampaignSeed + 44 + static_cast<std::uint64_t>(6 * draw);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random{seed};
    const RandomChain chain = test::ChainMaker{random, robot, Laws::kMixed, true, Begin::kAnywhere}.make();
    PathRig rig{chain.robot, 20.0, chain.tool};
    rig.planner.begin(chain.start, chain.requests);
    if (rig.planner.work(kMaxSamples) != Progress::kDone || rig.planner.plan().duration.value() > kLongest) continue;
    const CartesianPlan& plan = rig.planner.plan();
    for (std::size_t i = 0; i + 1 < plan.count; ++i) {
      const CartesianSegment& segment = plan.segments[i];
      if (segment.corner == 0.0) continue;
      const double end = segment.from + segment.length;
      const double passed_s = plan.table.time_at(end + segment.corner) - plan.table.time_at(end - segment.corner);
      corners_within_tick += passed_s < kTickSeconds ? 1 : 0;
    }
    const SetPointJudge judge{chain, rig.arm};
    for (int shift = 0; shift < kShifts; ++shift) {
      SCOPED_TRACE("shifted by " + std::to_string(shift) + " / " + std::to_string(kShifts));
      EXPECT_EQ(judge.joint_limits(rig.set_points(static_cast<double>(shift) / kShifts), false, 0.0), "");
    }
  }
  EXPECT_GE(corners_within_tick, 1);
}

// In the order of Floors.
INSTANTIATE_TEST_SUITE_P(
    Arms, CartesianCampaign,
    testing::Values(Part{"abb_irb120", Begin::kAnywhere, {117, 91, 11, 54, 6381, 15, 0, 3, 0, 0}},
                    Part{"abb_irb120", Begin::kNearLimits, {79, 58, 11, 37, 2648, 13, 0, 127, 0, 0}},
                    Part{"abb_irb120", Begin::kNearWrist, {21, 19, 0, 9, 2156, 2, 3, 21, 0, 97}},
                    Part{"kuka_kr6_r900", Begin::kAnywhere, {123, 76, 14, 56, 5595, 16, 0, 3, 0, 0}},
                    Part{"kuka_kr6_r900", Begin::kNearLimits, {90, 53, 15, 37, 12070, 12, 0, 135, 0, 0}},
                    Part{"kuka_kr6_r900", Begin::kNearWrist, {24, 20, 2, 15, 683, 4, 2, 25, 0, 87}},
                    Part{"fanuc_lrmate200id", Begin::kAnywhere, {129, 70, 14, 59, 7719, 16, 0, 2, 0, 0}},
                    Part{"fanuc_lrmate200id", Begin::kNearLimits, {92, 53, 14, 39, 4902, 13, 0, 138, 0, 0}},
                    Part{"fanuc_lrmate200id", Begin::kNearWrist, {39, 31, 2, 22, 721, 6, 20, 31, 0, 72}},
                    Part{"vo2021_6r", Begin::kAnywhere, {98, 87, 9, 46, 9877, 11, 0, 1, 0, 2}},
                    Part{"vo2021_6r", Begin::kNearLimits, {64, 60, 11, 25, 4419, 7, 0, 134, 0, 6}},
                    Part{"vo2021_6r", Begin::kNearWrist, {11, 11, 0, 7, 29, 2, 9, 6, 0, 157}},
                    Part{"hu2012_5r", Begin::kAnywhere, {81, 75, 7, 37, 5885, 9, 0, 2, 25, 0}},
                    Part{"hu2012_5r", Begin::kNearLimits, {53, 52, 5, 21, 3348, 7, 0, 62, 74, 0}}),
    [](const auto& part) { return name_of(part.param); });

}  // namespace
}  // namespace armature
