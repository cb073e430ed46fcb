// Holds, overrides and stops on paths of the tool: within the joints' limits at 100 %, on the path, to its exact end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "controller/robot/axis_units.hpp"
#include "controller/trajectory/sampler.hpp"
#include "tests/controller/path_rig.hpp"
#include "tests/controller/random.hpp"

namespace armature {
namespace {

using test::degrees;
using test::PathRig;

constexpr double kRounding = 2e-6;

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
    const Transform to =
        test::turned_by(test::moved(from, random.real(-60, 60), random.real(-60, 60), random.real(-60, 60)),
                        random.real(-0.4, 0.4), {random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)});
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
    sampler_.start(MotionPlan{rig.planner.plan()}, rate);
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
      ASSERT_LE(std::fabs(step) / kTickSeconds, AxisUnits{model}.max_speed_rad_s() * (1.0 + kRounding))
          << "axis " << axis + 1 << " at " << elapsed;
      ASSERT_LE(std::fabs(step - last) / (kTickSeconds * kTickSeconds), model.max_accel_rad_s2 * (1.0 + kRounding))
          << "axis " << axis + 1 << " at " << elapsed << ", rate " << sampler_.rate();
    }
    // The joints hold the tool where the plan has it at some moment, in their order.
    const Transform tool = rig_.tool_at(points_.back());
    const Transform planned = tool_pose(rig_.planner.plan(), std::min(elapsed, duration_ticks()) * kTickSeconds);
    ASSERT_LT((tool.position_mm - planned.position_mm).norm(), 1e-9);
    ASSERT_LT((tool.rotation - planned.rotation).norm(), 1e-6);  // at the wrist singularity theta_4 is kept
  }

  [[nodiscard]] double duration_ticks() const { return static_cast<double>(rig_.planner.plan().duration.value()); }
  [[nodiscard]] const Sampler& sampler() const { return sampler_; }
  [[nodiscard]] int most_inverses() const { return most_inverses_; }

 private:
  const PathRig& rig_;
  Sampler sampler_;
  std::vector<JointAngles> points_;
  int most_inverses_ = 0;
};

TEST(CartesianHold, AnyRatesAtAnyTimeKeepLimitsPathAndEnd) {
  constexpr std::uint64_t kSeed = 61;
  test::Random random{kSeed};
  int executed = 0, most_inverses = 0, standstills = 0;
  for (int draw = 0; draw < 60; ++draw) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw));
    PathRig rig{test::irb120()};
    if (!plan_chain(random, rig)) continue;
    ++executed;
    double wanted = random.integer(0, 1) == 0 ? 1.0 : random.real(0.01, 1.0);
    Execution run{rig, wanted};
    std::int64_t change = random.integer(0, 400);
    for (std::int64_t tick = 0; run.sampler().busy(); ++tick) {
      if (tick == change) {
        const double choices[] = {0.0, 0.01, 1.0, random.real(0.01, 1.0)};
        wanted = tick > 6'000 ? 1.0 : choices[random.integer(0, 3)];
        change += random.integer(1, 500);
      }
      run.tick(wanted);
      if (HasFatalFailure()) return;
      standstills += run.sampler().rate() == 0.0 ? 1 : 0;
      ASSERT_LT(tick, 60'000) << "does not end";
    }
    EXPECT_EQ(run.sampler().position(), rig.planner.plan().target);
    most_inverses = std::max(most_inverses, run.most_inverses());
  }
  EXPECT_GT(executed, 25);
  EXPECT_GT(standstills, 1'000);
  EXPECT_LE(most_inverses, PathClock::kMostEvaluations);
  RecordProperty("most_inverses", most_inverses);
}

// The tool is tilted, bent and off the arm's plane; pitch, roll and heading change together.
TEST(CartesianHold, FiveJointsKeepLimitsPathAndEndAtAnyRates) {
  constexpr std::uint64_t kSeed = 63;
  test::Random random{kSeed};
  const Transform tool{.rotation = rotation_from_rpy(0.3, -0.2, 0.1), .position_mm = {10, -15, 40}};
  int executed = 0, standstills = 0;
  for (int draw = 0; draw < 40; ++draw) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw));
    PathRig rig{test::hu2012(1.0), 20.0, tool};
    if (!plan_chain(random, rig)) continue;
    ++executed;
    Execution run{rig, 1.0};
    for (std::int64_t tick = 0; run.sampler().busy(); ++tick) {
      run.tick(tick > 6'000 || tick % 700 < 350 ? 1.0 : 0.0);
      if (HasFatalFailure()) return;
      standstills += run.sampler().rate() == 0.0 ? 1 : 0;
      ASSERT_LT(tick, 60'000) << "does not end";
    }
    EXPECT_EQ(run.sampler().position(), rig.planner.plan().target);
  }
  EXPECT_GT(executed, 15);
  EXPECT_GT(standstills, 1'000);
}

TEST(CartesianHold, AHoldComesToAStandstillWhereverItIsAskedFor) {
  constexpr std::uint64_t kSeed = 62;
  test::Random random{kSeed};
  for (int draw = 0; draw < 30; ++draw) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw));
    PathRig rig{test::irb120()};
    if (!plan_chain(random, rig)) continue;
    Execution run{rig, 1.0};
    const double from = random.real(0.0, 0.95) * run.duration_ticks();
    while (run.sampler().elapsed() < from) run.tick(1.0);
    const double at = run.sampler().elapsed();
    int ticks = 0;
    for (; run.sampler().busy() && run.sampler().rate() > 0.0; ++ticks) {
      run.tick(0.0);
      if (HasFatalFailure()) return;
      ASSERT_LT(ticks, 5'000);
    }
    // From the top speed every joint can stop in 0.1 s; where joints turn round within the braking it takes longer.
    EXPECT_LE(run.sampler().elapsed() - at, 3'000.0);
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
