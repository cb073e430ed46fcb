// Holds, overrides and stops on paths of the tool: within the joints' limits at 100 %, on the path, to its exact end.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "controller/robot/axis_units.hpp"
#include "controller/trajectory/run/sampler.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/keeping_sampler.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::degrees;
using test::moved;
using test::PathRig;

// Set-points of a change of the rate are 1e-10 rad from the path at most (PathClock), at a reach of 1 m.
constexpr double kOffPath_mm = 1e-7;
constexpr double kHoldRounding = 2e-6;
constexpr double kTool = 1.002;  // the planner lets the tool exceed its limits by a thousandth in rounded corners

// A random chain of lines and arcs with and without blends from a random posture; false when it cannot be planned.
bool plan_chain(test::Random& random, PathRig& rig) {
  const bool six = rig.robot.axis_count == 6;
  const JointAngles start = six ? degrees({random.real(-60, 60), random.real(-30, 40), random.real(-20, 40),
                                           random.real(-60, 60), random.real(20, 90), random.real(-90, 90)})
                                : degrees({random.real(-60, 60), random.real(-70, -40), random.real(60, 90),
                                           random.real(-50, 40), random.real(-90, 90), 0.0});
  std::vector<SegmentRequest> chain;
  Transform from = rig.tool_at(start);
  const bool scurve = random.integer(0, 3) == 0;
  for (auto count = random.integer(1, 4); count > 0; --count) {
    // Into variables: each compiler has its own order of arguments.
    const Eigen::Vector3d axis{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
    const double angle = random.real(-0.4, 0.4);
    const double z = random.real(-60, 60), y = random.real(-60, 60), x = random.real(-60, 60);
    const Transform to = test::turned_by(test::moved(from, x, y, z), angle, axis);
    const PathLimits& limits = random.integer(0, 2) == 0 ? test::kGentle : test::kBrisk;
    const double blend_mm = random.integer(0, 1) == 0 ? 0.0 : random.real(1.0, 30.0);
    const ProfileKind profile = scurve ? ProfileKind::kSCurve : ProfileKind::kTrapezoid;
    if (random.integer(0, 2) == 0) {
      const Eigen::Vector3d via_mm = 0.5 * (from.position_mm + to.position_mm) +
                                     Eigen::Vector3d{random.real(-20, 20), random.real(-20, 20), random.real(-20, 20)};
      chain.push_back(test::arc_to(via_mm, to, limits, blend_mm, profile));
    } else {
      chain.push_back(test::line_to(to, limits, blend_mm, profile));
    }
    from = to;
  }
  return rig.plan(start, chain) == CartesianPlanner::Progress::kDone;
}

// Executes a plan and looks at every set-point.
class Execution {
 public:
  Execution(const PathRig& rig, double rate)
      : rig_{rig}, sampler_{rig.robot, rig.arm, rig.planner.plan().start}, points_(2, sampler_.position()) {
    sampler_.start(rig.planner.plan(), rate);
  }

  void tick(double wanted) {
    const double before = sampler_.elapsed();
    points_.push_back(sampler_.advance(wanted));
    const double elapsed = sampler_.elapsed();
    ASSERT_GE(elapsed, before);
    ASSERT_LE(elapsed, before + 1.0);
    most_inverses_ = std::max(most_inverses_, sampler_.inverses());
    const std::size_t k = points_.size() - 1;
    for (std::size_t axis = 0; axis < rig_.robot.axis_count; ++axis) {
      const AxisModel& model = rig_.robot.axes[axis];
      const double step = (points_[k][axis] - points_[k - 1][axis]).value();
      const double last = (points_[k - 1][axis] - points_[k - 2][axis]).value();
      ASSERT_LE(std::fabs(step) / kTickSeconds, AxisUnits{model}.max_speed_rad_s() * (1.0 + kHoldRounding))
          << "axis " << axis + 1 << " at " << elapsed;
      ASSERT_LE(std::fabs(step - last) / (kTickSeconds * kTickSeconds), model.max_accel_rad_s2 * (1.0 + kHoldRounding))
          << "axis " << axis + 1 << " at " << elapsed << ", rate " << sampler_.rate();
    }
    // The joints hold the tool where the plan has it at some moment, in their order.
    const Transform tool = rig_.tool_at(points_.back());
    const ToolSample sample = tool_sample(rig_.planner.plan(), std::min(elapsed, duration_ticks()) * kTickSeconds);
    const Transform& planned = sample.tool.base_T_tool;
    ASSERT_LT((tool.position_mm - planned.position_mm).norm(), kOffPath_mm);
    ASSERT_LT((tool.rotation - planned.rotation).norm(), 1e-6);  // at the wrist singularity theta_4 is kept
    expect_tool_limits(sample, before, elapsed);
  }

  [[nodiscard]] double duration_ticks() const { return static_cast<double>(rig_.planner.plan().duration.value()); }
  [[nodiscard]] const Sampler& sampler() const { return sampler_; }
  // Of the tool, in the last tick.
  [[nodiscard]] double speed_mm_s() const { return move_.norm() / kTickSeconds; }
  [[nodiscard]] int most_inverses() const { return most_inverses_; }

 private:
  // The tool's position and the turning that is limited, by differences, against the limits of the move: at a corner
  // the larger ones of both.
  void expect_tool_limits(const ToolSample& tool, double from, double to) {
    const CartesianPlan& plan = rig_.planner.plan();
    double accel = 0.0, turn_accel = 0.0;
    for (std::size_t i = 0; i < plan.count; ++i) {
      const CartesianSegment& segment = plan.segments[i];
      const auto start = static_cast<double>(segment.start.value());
      if (start + static_cast<double>(segment.duration.value()) <= from - 1.0 || start >= to) continue;
      accel = std::max(accel, chain_limits(i).accel_mm_s2);
      turn_accel = std::max(turn_accel, chain_limits(i).turn_accel_rad_s2);
    }
    const Eigen::Vector3d move = tool.tool.base_T_tool.position_mm - tool_.tool.base_T_tool.position_mm;
    const Eigen::Quaterniond q{Eigen::Matrix3d{tool.rotation * tool_.rotation.transpose()}};
    const Eigen::Vector3d in_space = std::copysign(2.0, q.w()) * q.vec();
    const Eigen::Vector3d turn = tool.in_plane ? limited_turn(tool_, tool) : in_space;
    constexpr double kTick2 = kTickSeconds * kTickSeconds;
    ASSERT_LE((move - move_).norm() / kTick2, accel * kTool) << "at " << to << ", rate " << sampler_.rate();
    ASSERT_LE((turn - turn_).norm() / kTick2, turn_accel * kTool) << "at " << to << ", rate " << sampler_.rate();
    tool_ = tool;
    move_ = move;
    turn_ = turn;
  }
  [[nodiscard]] const PathLimits& chain_limits(std::size_t segment) const {
    return rig_.planner.plan().segments[segment].limits;
  }

  const PathRig& rig_;
  test::KeepingSampler sampler_;
  ToolSample tool_ = tool_sample(rig_.planner.plan(), 0.0);
  Eigen::Vector3d move_ = Eigen::Vector3d::Zero(), turn_ = Eigen::Vector3d::Zero();
  std::vector<JointAngles> points_;
  int most_inverses_ = 0;
};

TEST(CartesianHold, AnyRatesAtAnyTimeKeepLimitsPathAndEnd) {
  constexpr std::uint64_t kSeed = 61;
  test::Random random{kSeed};
  int executed = 0, most_inverses = 0, standstills = 0;
  for (int draw = 0; draw < test::draws(30); ++draw) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw));
    PathRig rig{test::irb120()};
    if (!plan_chain(random, rig)) continue;
    ++executed;
    double wanted = random.integer(0, 1) == 0 ? 1.0 : random.real(0.01, 1.0);
    Execution run{rig, wanted};
    std::int64_t change = random.integer(0, 4'000);
    for (std::int64_t tick = 0; run.sampler().busy(); ++tick) {
      if (tick == change) {
        const double choices[] = {0.0, 0.01, 1.0, random.real(0.01, 1.0)};
        wanted = tick > 16'000 ? 1.0 : choices[random.integer(0, 3)];
        change += random.integer(1, 2'500);
      }
      run.tick(wanted);
      if (HasFatalFailure()) return;
      standstills += run.sampler().rate() == 0.0 ? 1 : 0;
      ASSERT_LT(static_cast<double>(tick), 40'000.0 + run.duration_ticks()) << "does not end";
    }
    EXPECT_EQ(run.sampler().position(), rig.planner.plan().target);
    most_inverses = std::max(most_inverses, run.most_inverses());
  }
  EXPECT_GT(executed, test::least(12));
  EXPECT_GT(standstills, test::least(1'000));
  EXPECT_LE(most_inverses, PathClock::kMaxEvaluations);
  RecordProperty("most_inverses", most_inverses);
}

// The tool is tilted, bent and off the arm's plane; pitch, roll and heading change together.
TEST(CartesianHold, FiveJointsKeepLimitsPathAndEndAtAnyRates) {
  constexpr std::uint64_t kSeed = 63;
  test::Random random{kSeed};
  const Transform tool{.rotation = rotation_from_rpy(0.3, -0.2, 0.1), .position_mm = {10, -15, 40}};
  int executed = 0, standstills = 0;
  for (int draw = 0; draw < test::draws(40); ++draw) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw));
    PathRig rig{test::hu2012(1.0), 20.0, tool};
    if (!plan_chain(random, rig)) continue;
    ++executed;
    Execution run{rig, 1.0};
    for (std::int64_t tick = 0; run.sampler().busy(); ++tick) {
      run.tick(tick > 12'000 || tick % 1'400 < 350 ? 1.0 : 0.0);
      if (HasFatalFailure()) return;
      standstills += run.sampler().rate() == 0.0 ? 1 : 0;
      ASSERT_LT(static_cast<double>(tick), 40'000.0 + run.duration_ticks()) << "does not end";
    }
    EXPECT_EQ(run.sampler().position(), rig.planner.plan().target);
  }
  EXPECT_GT(executed, test::least(15));
  EXPECT_GT(standstills, test::least(1'000));
}

// The speed of the tool never grows while a hold is under way. With limited jerk it may: what the plan speeds up by
// goes on until the rate, which falls as an S, outweighs it. With the rate r of a hold of T s the speed is at most (v_0
// + A t) r, and t r has its maximum 0.272 T on the S r = 1 - 2 (t / T)^2.
TEST(CartesianHold, AHoldComesToAStandstillWhereverItIsAskedFor) {
  constexpr std::uint64_t kSeed = 62;
  constexpr double kGrowth = 0.273;
  test::Random random{kSeed};
  int executed = 0, scurves = 0, over = 0;
  for (int draw = 0; draw < test::draws(30); ++draw) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw));
    PathRig rig{test::irb120()};
    if (!plan_chain(random, rig)) continue;
    ++executed;
    const CartesianPlan& plan = rig.planner.plan();
    const bool scurve = plan.segments[0].profile == ProfileKind::kSCurve;
    scurves += scurve ? 1 : 0;
    Execution run{rig, 1.0};
    const double from = random.real(0.0, 0.95) * run.duration_ticks();
    while (run.sampler().elapsed() < from) run.tick(1.0);
    const double speed_mm_s = run.speed_mm_s();
    double last_mm_s = speed_mm_s, most_mm_s = speed_mm_s, last_rate = run.sampler().rate();
    // All laws can stop in 0.1 s, S-curves in 0.224 s; where joints turn round within that it takes a little longer.
    const int most_ticks = scurve ? 4'600 : 2'100;
    int ticks = 0;
    for (; run.sampler().busy() && run.sampler().rate() > 0.0; ++ticks) {
      run.tick(0.0);
      if (HasFatalFailure()) return;
      ASSERT_LT(ticks, most_ticks);
      ASSERT_LE(run.sampler().rate(), last_rate) << "after " << ticks;
      if (!scurve) {
        ASSERT_LE(run.speed_mm_s(), last_mm_s + 1e-6) << "after " << ticks;
      }
      last_rate = run.sampler().rate();
      last_mm_s = run.speed_mm_s();
      most_mm_s = std::max(most_mm_s, last_mm_s);
    }
    double accel_mm_s2 = 0.0;
    for (std::size_t i = 0; i < plan.count; ++i) {
      accel_mm_s2 = std::max(accel_mm_s2, plan.segments[i].limits.accel_mm_s2);
    }
    EXPECT_LE(most_mm_s, speed_mm_s + kGrowth * accel_mm_s2 * ticks * kTickSeconds + 1e-6);
    if (!run.sampler().busy()) {
      ++over;
      continue;
    }
    const JointAngles stands = run.sampler().position();
    EXPECT_EQ(run.sampler().rate(), 0.0);
    for (int tick = 0; tick < 10; ++tick) run.tick(0.0);
    EXPECT_EQ(run.sampler().position(), stands);
    EXPECT_EQ(run.sampler().rate(), 0.0);
  }
  EXPECT_GE(executed, test::least(25));
  EXPECT_GE(scurves, test::least(4));
  EXPECT_LE(over, 2) << "the plan ended first";
}

TEST(CartesianHold, BrakesAndSpeedsUpWithTheAccelerationOfTheMove) {
  PathRig rig{test::irb120()};
  const JointAngles start = degrees({10, 20, 10, 5, 40, 0});
  ASSERT_EQ(rig.plan(start, test::line_to(test::moved(rig.tool_at(start), 60, 40, -20), test::kGentle)),
            CartesianPlanner::Progress::kDone);
  Execution run{rig, 1.0};
  while (run.sampler().elapsed() < 0.5 * run.duration_ticks()) run.tick(1.0);
  int braking = 0, speeding_up = 0;
  for (; run.sampler().rate() > 0.0 && braking < 10'000; ++braking) run.tick(0.0);
  for (; run.sampler().rate() < 1.0 && speeding_up < 10'000; ++speeding_up) run.tick(1.0);
  EXPECT_NEAR(braking, 2'000, 5);  // 100 mm/s with 1000 mm/s^2
  EXPECT_NEAR(speeding_up, 2'000, 5);
}

// On a circle every change of the rate bends the tool's way differently: what is tried is accepted only to rounding.
TEST(CartesianHold, OnACircleTheToolKeepsItsAccelerationToRounding) {
  PathRig rig{test::irb120()};
  const JointAngles start = degrees({10, 20, 10, 5, 40, 0});
  const Transform from = rig.tool_at(start);
  PathLimits limits = test::kGentle;
  limits.speed_mm_s = 60.0;
  const auto circle = test::circle_through(from.position_mm + Eigen::Vector3d{3, 3, 0}, moved(from, 0, 6, 0), limits);
  ASSERT_EQ(rig.plan(start, circle), CartesianPlanner::Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  for (const std::int64_t every : {37, 150, 601}) {
    test::KeepingSampler sampler{rig.robot, rig.arm, start};
    sampler.start(plan, 1.0);
    std::array<Eigen::Vector3d, 3> tool;
    tool.fill(from.position_mm);
    double accel = 0.0;
    for (std::int64_t tick = 0; sampler.busy(); ++tick) {
      ASSERT_LT(tick, 100'000);
      const double wanted = tick < 20'000 && tick / every % 2 == 1 ? 0.0 : 1.0;
      tool = {rig.tool_at(sampler.advance(wanted)).position_mm, tool[0], tool[1]};
      accel = std::max(accel, (tool[0] - 2.0 * tool[1] + tool[2]).norm() / (kTickSeconds * kTickSeconds));
    }
    EXPECT_LE(accel, limits.accel_mm_s2 * (1.0 + 3e-4)) << "changes every " << every;
    EXPECT_GT(accel, limits.accel_mm_s2 * 0.99) << "changes every " << every;
  }
}

TEST(CartesianHold, AProtectiveStopBrakesAsFastAsTheJointsMay) {
  PathRig rig{test::irb120()};
  const JointAngles start = degrees({10, 20, 10, 5, 40, 0});
  for (const ProfileKind profile : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    ASSERT_EQ(rig.plan(start, test::line_to(test::moved(rig.tool_at(start), 60, 40, -20), test::kGentle, 0.0, profile)),
              CartesianPlanner::Progress::kDone);
    test::KeepingSampler sampler{rig.robot, rig.arm, start};
    sampler.start(rig.planner.plan(), 1.0);
    std::vector<JointAngles> joints(4, start);
    for (int tick = 0; tick < 6'000; ++tick) joints.push_back(sampler.advance(1.0));
    int braking = 0;
    for (; sampler.rate() > 0.0 && braking < 10'000; ++braking) joints.push_back(sampler.brake());
    EXPECT_LT(braking, 200);  // a hold takes 2000
    const double accel = test::joint_peaks(rig.robot, joints).accel;
    EXPECT_GT(accel, 0.99);
    EXPECT_LE(accel, 1.0 + kHoldRounding);
  }
}

TEST(CartesianHold, AtTheWantedRateATickCostsOneInverse) {
  PathRig rig{test::irb120()};
  const JointAngles start = degrees({10, 20, 10, 5, 40, 0});
  ASSERT_EQ(rig.plan(start, test::line_to(test::moved(rig.tool_at(start), 40, 30, -20), test::kGentle)),
            CartesianPlanner::Progress::kDone);
  for (const double rate : {1.0, 0.25}) {
    Execution run{rig, rate};
    std::int64_t ticks = 0;
    for (; run.sampler().busy(); ++ticks) run.tick(rate);
    EXPECT_EQ(run.most_inverses(), 1);
    EXPECT_NEAR(static_cast<double>(ticks), run.duration_ticks() / rate, 1.0);
  }
}

}  // namespace
}  // namespace armature
