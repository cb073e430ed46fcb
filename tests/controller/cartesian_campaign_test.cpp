// Thousands of random moves of every arm of the project: what the planner accepts keeps every limit, stays on its path
// and on its branch and ends where it was asked to, at ticks, between ticks, and under holds, overrides and stops.
//
// ARMATURE_CAMPAIGN=<n> in the environment drives n times as many chains, with other seeds.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <ostream>
#include <string>

#include "controller/trajectory/sampler.hpp"
#include "tests/controller/path_rig.hpp"
#include "tests/controller/random_chains.hpp"
#include "tests/controller/robot_files.hpp"
#include "tests/controller/set_point_judge.hpp"

namespace armature {
namespace {

using test::Begin;
using test::Laws;
using test::PathRig;
using test::Random;
using test::RandomChain;
using test::SetPointJudge;
using Progress = CartesianPlanner::Progress;

constexpr std::uint64_t kSeed = 7'000;
// Set-points that may be planned for one chain; longer ones are left out, to drive more short ones.
constexpr std::size_t kMostSamples = 12'000;
constexpr std::int64_t kLongest = 4'000;
// Limits are kept to the plan's own margin where the rate does not change, otherwise to rounding.
constexpr double kRounding = 2e-6;

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
    const Progress progress = rig.planner.work(kMostSamples);
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
      if (i == 0) continue;
      const CartesianSegment& before = plan.segments[i - 1];
      blended = blended || segment.start < before.start + before.duration;
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
    Sampler sampler{chain.robot, rig.arm, plan.start};
    sampler.start(MotionPlan{plan}, wanted);
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
      ASSERT_LE(sampler.inverses(), Sampler::kMostInverses);
      tally.standstills += sampler.busy() && sampler.rate() == 0.0 ? 1 : 0;
      ASSERT_LT(tick, 15 * kLongest) << "does not end";
    }
    ++tally.at_rates;
    tally.stops += sampler.busy() ? 1 : 0;
    if (!sampler.busy()) {
      ASSERT_EQ(joints.back(), plan.target);
    }
    joints.insert(joints.end(), 4, joints.back());
    ASSERT_EQ(judge.judge(joints, {.slack = kRounding, .with_tool = stop < 0, .to_the_end = !sampler.busy()}), "");
  }

  Random random_{0};
};

struct Part {
  const char* robot;
  Begin begin;
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
  const auto [name, begin] = GetParam();
  const RobotModel robot = test::robot_of_file(name);
  const bool six = robot.arm.family == ArmFamily::kSixR;
  const int count = times_as_many() * chains(begin);
  Campaign campaign;
  for (int draw = 0; draw < count; ++draw) {
    const std::uint64_t seed = kSeed + static_cast<std::uint64_t>(draw);
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
  EXPECT_EQ(sum, count) << "refused for another reason";
  EXPECT_LT(tally.left_out, count / 2);
  // Of each kind enough, by what the chains begin with; the singularity makes most of them too fast.
  const bool wrist = begin == Begin::kNearWrist;
  EXPECT_GE(tally.accepted, wrist ? 2 : 70);
  EXPECT_GE(tally.stretched, wrist ? 2 : 50);
  EXPECT_GE(tally.blended, wrist ? 0 : 5);
  EXPECT_GE(tally.at_rates, wrist ? 1 : 25);
  EXPECT_GE(tally.standstills, wrist ? 1 : 1'000);
  EXPECT_GE(tally.stops, wrist ? 0 : 5);
  EXPECT_GE(tally.through_wrist, wrist ? 1 : 0);
  if (begin == Begin::kNearLimits) {
    EXPECT_GE(refused(Kind::kOutsideLimits), 80);
  }
  if (wrist) {
    EXPECT_GE(refused(Kind::kTooFast), 100);
  }
  if (!six) {
    EXPECT_GE(refused(Kind::kOrientation), 30);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Arms, CartesianCampaign,
    testing::Values(Part{"abb_irb120", Begin::kAnywhere}, Part{"abb_irb120", Begin::kNearLimits},
                    Part{"abb_irb120", Begin::kNearWrist}, Part{"kuka_kr6_r900", Begin::kAnywhere},
                    Part{"kuka_kr6_r900", Begin::kNearLimits}, Part{"kuka_kr6_r900", Begin::kNearWrist},
                    Part{"fanuc_lrmate200id", Begin::kAnywhere}, Part{"fanuc_lrmate200id", Begin::kNearLimits},
                    Part{"fanuc_lrmate200id", Begin::kNearWrist}, Part{"vo2021_6r", Begin::kAnywhere},
                    Part{"vo2021_6r", Begin::kNearLimits}, Part{"vo2021_6r", Begin::kNearWrist},
                    Part{"hu2012_5r", Begin::kAnywhere}, Part{"hu2012_5r", Begin::kNearLimits}),
    [](const auto& part) { return name_of(part.param); });

}  // namespace
}  // namespace armature
