// Random chains of segments: whatever the planner accepts keeps every limit, computed here from set-points alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random_chains.hpp"

namespace armature {
namespace {

using test::Laws;
using test::PathRig;
using test::Random;
using test::random_vector;

JointAngles random_start(Random& random, const RobotModel& robot) {
  JointAngles joints{};
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    const AxisModel& model = robot.axes[axis];
    joints[axis] = Radians{random.real(0.8 * model.min_rad, 0.8 * model.max_rad)};
  }
  return joints;
}

struct Chain {
  JointAngles start{};
  std::vector<SegmentRequest> requests;
  PathLimits limits{};  // the same for all
};

Chain random_chain(Random& random, const PathRig& rig, Laws laws, bool blended) {
  Chain chain;
  chain.start = random_start(random, rig.robot);
  const double pace = random.real(0.3, 2.0);
  chain.limits = {.speed_mm_s = 700.0 * pace,
                  .accel_mm_s2 = 12'000.0 * pace,
                  .jerk_mm_s3 = 1e6 * pace,
                  .turn_speed_rad_s = 6.0 * pace,
                  .turn_accel_rad_s2 = 100.0 * pace,
                  .turn_jerk_rad_s3 = 8'000.0 * pace};
  Transform at = rig.tool_at(chain.start);
  const std::int64_t count = random.integer(1, 4);
  for (std::int64_t i = 0; i < count; ++i) {
    const ProfileKind kind = laws == Laws::kTrapezoids                             ? ProfileKind::kTrapezoid
                             : laws == Laws::kSCurves || random.integer(0, 1) == 0 ? ProfileKind::kSCurve
                                                                                   : ProfileKind::kTrapezoid;
    const double blend_mm = blended ? random.real(0.0, 5.0) : 0.0;
    const Eigen::Vector3d middle = at.position_mm + random_vector(random, 12.0);
    const std::int64_t shape = random.integer(0, 5);
    if (shape != 0) at.position_mm += random_vector(random, 15.0);
    if (shape != 1) at = test::turned_by(at, random.real(0.0, 0.3), random_vector(random, 1.0));
    chain.requests.push_back(shape == 2 ? test::arc_to(middle, at, chain.limits, blend_mm, kind)
                                        : test::line_to(at, chain.limits, blend_mm, kind));
  }
  return chain;
}

double distance(const Eigen::Vector3d& p, const PositionPath& path) {
  const double to_ends = std::min((p - path.start_mm).norm(), (p - path.end_mm).norm());
  if (path.shape == PositionPath::Shape::kArc) {
    const Eigen::Vector3d d = p - path.center_mm;
    double phi = std::atan2(d.dot(path.y), d.dot(path.x));
    if (phi < 0.0) phi += 2.0 * std::numbers::pi;
    if (phi > path.angle_rad) return to_ends;
    return std::hypot(std::hypot(d.dot(path.x), d.dot(path.y)) - path.radius_mm, d.dot(path.x.cross(path.y)));
  }
  const Eigen::Vector3d along = path.end_mm - path.start_mm;
  const double s = along.dot(p - path.start_mm) / along.squaredNorm();
  return s > 0.0 && s < 1.0 ? (p - path.start_mm - s * along).norm() : to_ends;
}

// A plan with a table: outside of its corners the tool is on the segment, within them it is blend_mm from the path.
void expect_on_segments(const CartesianPlan& plan, const Chain& chain) {
  for (std::int64_t tick = 0; tick <= plan.duration.value(); ++tick) {
    const double t_s = static_cast<double>(tick) * kTickSeconds, s = plan.table.position(t_s);
    const Eigen::Vector3d p = tool_pose(plan, t_s).position_mm;
    std::size_t i = 0;
    while (i + 1 < plan.count && plan.segments[i].from + plan.segments[i].length <= s) ++i;
    const CartesianSegment& segment = plan.segments[i];
    double most = 1e-9, off = distance(p, segment.path);
    if (i > 0 && s - segment.from < plan.segments[i - 1].corner) {
      most = chain.requests[i - 1].blend_mm * (1.0 + 1e-6);
      off = std::min(off, distance(p, plan.segments[i - 1].path));
    } else if (segment.from + segment.length - s < segment.corner) {
      most = chain.requests[i].blend_mm * (1.0 + 1e-6);
      off = std::min(off, distance(p, plan.segments[i + 1].path));
    }
    ASSERT_LT(off, most) << tick;
  }
}

struct PropertyTally {
  int accepted = 0, stretched = 0, blended = 0, passes = 0;
};

void check(const PathRig& rig, const Chain& chain, Laws laws, PropertyTally& tally) {
  const CartesianPlan& plan = rig.planner.plan();
  ++tally.accepted;
  tally.passes += rig.planner.passes();
  const auto joints = rig.set_points();
  for (std::size_t k = 4; k < joints.size(); k += 13) {
    const Transform pose = tool_pose(plan, static_cast<double>(k - 3) * kTickSeconds);
    const Transform reached = rig.tool_at(joints[k]);
    ASSERT_LT((reached.position_mm - pose.position_mm).norm(), 1e-9);
    ASSERT_LT((reached.rotation - pose.rotation).cwiseAbs().maxCoeff(), 1e-9);
  }
  const bool with_jerk = laws == Laws::kSCurves;
  ASSERT_LE(test::joint_peaks(rig.robot, joints).most(with_jerk), 1.0);
  const double shift = tally.accepted % 2 == 0 ? 0.5 : 0.27;  // as after a hold
  ASSERT_LE(test::joint_peaks(rig.robot, rig.set_points(shift)).most(with_jerk), 1.0) << shift;
  const bool six = rig.robot.arm.family == ArmFamily::kSixR;
  test::ToolPeaks tool = test::tool_peaks(plan, chain.limits);
  if (!six) test::limit_pitch_and_roll(tool, joints, chain.limits);
  ASSERT_LE(tool.most(), 1.002) << tool.speed << " " << tool.accel << " " << tool.turn_speed << " " << tool.turn_accel;
  expect_on_segments(plan, chain);
  const Transform end = tool_pose(plan, static_cast<double>(plan.duration.value()) * kTickSeconds);
  ASSERT_EQ(end.position_mm, chain.requests.back().target.position_mm);
  const Eigen::Matrix3d& asked = chain.requests.back().target.rotation;
  if (six) {
    ASSERT_EQ(end.rotation, asked);
  } else {
    ASSERT_LE(Eigen::AngleAxisd{Eigen::Matrix3d{asked.transpose() * end.rotation}}.angle(),
              rig.robot.arm.max_projection_rad);
  }
  ASSERT_EQ(joints.back(), plan.target);
  for (std::size_t i = 0; i < plan.count; ++i) {
    ASSERT_GE(plan.segments[i].stretch, 1.0);
    tally.stretched += plan.segments[i].stretch > 1.0 ? 1 : 0;
    const std::int64_t begin = plan.segments[i].start.value();
    tally.blended += i > 0 && begin < end_of(plan.segments[i - 1]).value() ? 1 : 0;
  }
}

// Returns what it has seen; refusals must be of a kind that random chains can meet.
PropertyTally run(std::uint64_t seed, int chains, const RobotModel& robot, Laws laws, bool blended) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random{seed};
  const bool six = robot.arm.family == ArmFamily::kSixR;
  PathRig rig{robot, 20.0, Transform{Eigen::Matrix3d::Identity(), {15, six ? 0.0 : -12.0, 40}}};
  PropertyTally tally;
  for (int draw = 0; draw < chains; ++draw) {
    SCOPED_TRACE("chain " + std::to_string(draw));
    const Chain chain = random_chain(random, rig, laws, blended);
    if (rig.plan(chain.start, chain.requests) == CartesianPlanner::Progress::kDone) {
      check(rig, chain, laws, tally);
      if (testing::Test::HasFatalFailure()) break;
    } else {
      const PathProblem::Kind kind = rig.planner.problem().kind;
      EXPECT_TRUE(kind == PathProblem::Kind::kUnreachable || kind == PathProblem::Kind::kOutsideLimits ||
                  kind == PathProblem::Kind::kTooFast || (!six && kind == PathProblem::Kind::kOrientation))
          << static_cast<int>(kind);
    }
  }
  return tally;
}

struct Kind {
  const char* name;
  std::uint64_t seed;
  Laws laws;
  bool blends;
  int fewest_stretched, fewest_blended;  // of what must occur
};

void PrintTo(const Kind& kind, std::ostream* out) {
  *out << kind.name;
}

class CartesianProperty : public testing::TestWithParam<Kind> {};

TEST_P(CartesianProperty, RandomChainsKeepEveryLimit) {
  const Kind& kind = GetParam();
  const PropertyTally tally = run(kind.seed, test::draws(70), test::irb120(), kind.laws, kind.blends);
  EXPECT_GT(tally.accepted, test::least(45));
  EXPECT_GE(tally.stretched, test::least(kind.fewest_stretched));
  EXPECT_GE(tally.blended, test::least(kind.fewest_blended));
  if (!kind.blends) {
    EXPECT_EQ(tally.blended, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Irb120, CartesianProperty,
                         testing::Values(Kind{"trapezoids", 31, Laws::kTrapezoids, false, 41, 0},
                                         Kind{"s_curves", 32, Laws::kSCurves, false, 41, 0},
                                         Kind{"blended_trapezoids", 33, Laws::kTrapezoids, true, 0, 31},
                                         Kind{"blended_s_curves", 34, Laws::kSCurves, true, 0, 11},
                                         Kind{"blends_of_both", 35, Laws::kMixed, true, 0, 21}),
                         [](const auto& kind) { return std::string{kind.param.name}; });

TEST(CartesianPropertyFiveJoints, KeepEveryLimitWhileTheyTakeTheNearestOrientation) {
  const PropertyTally tally = run(36, 80, test::hu2012(0.5), Laws::kTrapezoids, true);
  EXPECT_GT(tally.accepted, 40);
  EXPECT_GT(tally.blended, 30);
}

}  // namespace
}  // namespace armature
