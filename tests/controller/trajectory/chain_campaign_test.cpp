// A thousand random chains of lines and arcs, with and without common tangents, blends and limited jerk. They are
// judged by an oracle of their own in long double: from the requests it makes the ideal paths and the joints where a
// stop is asked for, from the set-points by forward kinematics the motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::PathRig;
using test::Random;
using Vector = Eigen::Matrix<long double, 3, 1>;

constexpr long double kTs = 50e-6L;

// A line, or an arc about `center` with the unit vectors x to the start and y along the motion.
struct IdealPath {
  Vector from, to, center, x, y;
  bool round = false;
  long double radius = 0.0L, angle = 0.0L;

  [[nodiscard]] Vector tangent(bool at_end) const {
    if (!round) return (to - from).normalized();
    return at_end ? Vector{std::cos(angle) * y - std::sin(angle) * x} : y;
  }
  [[nodiscard]] long double distance(const Vector& p) const {
    const long double ends = std::min((p - from).norm(), (p - to).norm());
    if (!round) {
      const Vector way = to - from;
      const long double share = way.dot(p - from) / way.squaredNorm();
      return share < 0.0L || share > 1.0L ? ends : (p - from - share * way).norm();
    }
    const Vector arm = p - center;
    long double phi = std::atan2(arm.dot(y), arm.dot(x));
    if (phi < 0.0L) phi += 2.0L * std::numbers::pi_v<long double>;
    const long double across = arm.dot(x.cross(y)), off = std::hypot(arm.dot(x), arm.dot(y)) - radius;
    return phi > angle ? ends : std::hypot(off, across);
  }
};

struct RandomPath {
  std::vector<SegmentRequest> requests;
  std::vector<IdealPath> ideal;
  PathLimits limits{};
  bool all_smooth = true;
};

Vector direction(Random& random) {
  Vector v;
  do {
    for (long double& x : v) x = static_cast<long double>(random.real(-1.0, 1.0));
  } while (!(v.norm() > 0.1L && v.norm() < 1.0L));
  return v.normalized();
}

RandomPath random_path(Random& random, const Transform& start) {
  RandomPath path;
  const double accel = std::exp(random.real(std::log(500.0), std::log(20'000.0)));
  const double speed = random.real(20.0, 800.0), jerk = accel * random.real(20.0, 200.0);
  path.limits = {.speed_mm_s = speed,
                 .accel_mm_s2 = accel,
                 .jerk_mm_s3 = jerk,
                 .turn_speed_rad_s = 10.0,
                 .turn_accel_rad_s2 = 200.0,
                 .turn_jerk_rad_s3 = 2e4};
  const std::int64_t count = random.integer(2, 8), kinds = random.integer(0, 2);  // profiles: two alike, or mixed
  Vector at = start.position_mm.cast<long double>(), along = direction(random);
  for (std::int64_t i = 0; i < count; ++i) {
    IdealPath piece;
    const bool tangent = random.integer(0, 2) == 0;
    if (!tangent || i == 0) along = direction(random);
    const auto length = static_cast<long double>(std::exp(random.real(std::log(0.5), std::log(12.0))));
    piece.from = at;
    piece.round = random.integer(0, 2) == 0;
    Transform target = start;
    SegmentRequest request;
    if (piece.round) {
      piece.angle = static_cast<long double>(random.real(0.3, 4.0));
      piece.radius = length / piece.angle;
      piece.y = along;
      piece.x = along.cross(direction(random)).normalized();
      piece.center = at - piece.radius * piece.x;
      const auto on = [&](long double phi) -> Vector {
        return piece.center + piece.radius * (std::cos(phi) * piece.x + std::sin(phi) * piece.y);
      };
      at = on(piece.angle);
      request.kind = SegmentRequest::Kind::kArc;
      request.via_mm = on(0.5L * piece.angle).cast<double>();
    } else {
      at += length * along;
    }
    piece.to = at;
    target.position_mm = at.cast<double>();
    request.target = target;
    request.limits = path.limits;
    const bool smooth = kinds == 0 || (kinds == 2 && random.integer(0, 1) == 0);
    request.profile = smooth ? ProfileKind::kSCurve : ProfileKind::kTrapezoid;
    request.blend_mm = random.integer(0, 1) == 0 ? 0.0 : static_cast<double>(length) * random.real(0.05, 0.3);
    path.all_smooth = path.all_smooth && smooth;
    along = piece.tangent(true);
    path.requests.push_back(request);
    path.ideal.push_back(piece);
  }
  return path;
}

// What is wrong first, or nothing.
std::string judge(const PathRig& rig, const RandomPath& path, const std::vector<JointAngles>& joints) {
  const auto at = [](std::size_t k) { return " at set-point " + std::to_string(k); };
  std::vector<Vector> tool;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    for (std::size_t axis = 0; axis < rig.robot.axis_count; ++axis) {
      if (!std::isfinite(joints[k][axis].value())) return "no number" + at(k);
    }
    tool.push_back(rig.tool_at(joints[k]).position_mm.cast<long double>());
  }
  const long double rounding = 1.002L, jerk_share = 1.05L;
  const PathLimits& most = path.limits;
  // A stop has steps of less; a joint that is passed has larger ones.
  const long double still =
      path.all_smooth ? 10.0L * most.jerk_mm_s3 * kTs * kTs * kTs : 0.4L * most.accel_mm_s2 * kTs * kTs;
  for (std::size_t k = 3; k < joints.size(); ++k) {
    for (std::size_t axis = 0; axis < rig.robot.axis_count; ++axis) {
      const AxisModel& model = rig.robot.axes[axis];
      const auto q = [&](std::size_t back) { return static_cast<long double>(joints[k - back][axis].value()); };
      const std::string of = " of axis " + std::to_string(axis + 1) + at(k);
      if (!(std::fabs(q(0) - q(1)) <= model.max_speed_rad_s * kTs)) return "speed" + of;
      if (!(std::fabs(q(0) - 2.0L * q(1) + q(2)) <= model.max_accel_rad_s2 * kTs * kTs)) return "acceleration" + of;
      const long double jerk = std::fabs(q(0) - 3.0L * q(1) + 3.0L * q(2) - q(3)) / (kTs * kTs * kTs);
      if (path.all_smooth && !(jerk <= jerk_share * model.max_jerk_rad_s3)) return "jerk" + of;
    }
    const Vector step = tool[k] - tool[k - 1], before = tool[k - 1] - tool[k - 2], first = tool[k - 2] - tool[k - 3];
    if (!(step.norm() <= rounding * most.speed_mm_s * kTs)) return "tool speed" + at(k);
    if (!((step - before).norm() <= rounding * most.accel_mm_s2 * kTs * kTs)) return "tool acceleration" + at(k);
    const long double jerk = (step - 2.0L * before + first).norm() / (kTs * kTs * kTs);
    if (path.all_smooth && !(jerk <= jerk_share * most.jerk_mm_s3)) return "tool jerk" + at(k);
  }
  std::size_t behind = 0;  // the piece that the tool is on, about
  for (std::size_t k = 0; k < tool.size(); ++k) {
    long double off = 1e9L, allowed = 1e-6L;
    std::size_t best = behind;
    for (std::size_t i = behind; i < std::min(behind + 2, path.ideal.size()); ++i) {
      const long double here = path.ideal[i].distance(tool[k]);
      if (here < off) best = i, off = here;
    }
    behind = best;
    for (const std::size_t i : {behind - 1, behind}) {
      if (i + 1 < path.ideal.size()) allowed = std::max(allowed, path.requests[i].blend_mm * 1.0001L);
    }
    if (!(off <= allowed)) return "path missed by " + std::to_string(static_cast<double>(off)) + at(k);
    const bool ends = (tool[k] - tool.front()).norm() < 1e-3L || (tool[k] - tool.back()).norm() < 1e-3L;
    if (k == 0 || ends || (tool[k] - tool[k - 1]).norm() > still) continue;
    bool asked = false;
    for (std::size_t i = 0; i + 1 < path.ideal.size(); ++i) {
      const long double turn = (path.ideal[i + 1].tangent(false) - path.ideal[i].tangent(true)).norm();
      const bool breaks = turn > 0.9e-3L && (path.requests[i].blend_mm == 0.0 || turn > 1.98L);
      asked = asked || (breaks && (tool[k] - path.ideal[i].to).norm() < 1e-2L);
    }
    if (!asked) return "a stop" + at(k);
  }
  return (tool.back() - path.ideal.back().to).norm() < 1e-6L ? "" : "end";
}

TEST(ChainCampaign, AThousandChainsKeepLimitsAndPathAndStopOnlyWhereAsked) {
  constexpr std::uint64_t kSeed = 14'000;
  const int chains = test::draws(1'000);
  int accepted = 0, smooth = 0, stopped = 0;
  for (int draw = 0; draw < chains; ++draw) {
    Random random{kSeed + static_cast<std::uint64_t>(draw)};
    PathRig rig{test::irb120(), 20.0};
    JointAngles start = test::kReady;
    for (Radians& joint : start) joint += Radians{random.real(-0.3, 0.3)};
    const RandomPath path = random_path(random, rig.tool_at(start));
    if (rig.plan(start, path.requests) != CartesianPlanner::Progress::kDone) continue;
    ++accepted;
    smooth += path.all_smooth ? 1 : 0;
    const double shift = draw % 2 == 0 ? 0.0 : random.real(0.0, 1.0);
    ASSERT_EQ(judge(rig, path, rig.set_points(shift)), "") << "draw " << draw << ", shifted by " << shift;
    const CartesianPlan& plan = rig.planner.plan();
    for (std::size_t i = 1; i < plan.count; ++i)
      stopped += plan.segments[i].start == end_of(plan.segments[i - 1]) ? 1 : 0;
  }
  EXPECT_GT(accepted, test::least(900));
  EXPECT_GT(smooth, test::least(250));
  EXPECT_GT(stopped, test::least(500));
}

// Rounded corners are passed at the programmed speed where the acceleration and the jerk allow it.
TEST(ChainCampaign, TheToolKeepsItsSpeedThroughRoundedCorners) {
  for (const ProfileKind profile : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    PathRig rig{test::irb120()};
    const Transform from = rig.tool_at(test::kReady);
    const PathLimits limits{.speed_mm_s = 100.0,
                            .accel_mm_s2 = 5'000.0,
                            .jerk_mm_s3 = 5e5,
                            .turn_speed_rad_s = 4.0,
                            .turn_accel_rad_s2 = 40.0,
                            .turn_jerk_rad_s3 = 4e3};
    const std::vector<Eigen::Vector2d> corners{{0, 40}, {-30, 60}, {-60, 60}, {-60, 20}};
    std::vector<SegmentRequest> chain;
    for (const Eigen::Vector2d& p : corners) {
      chain.push_back(test::line_to(test::moved(from, p.x(), p.y(), 0), limits, 2.0, profile));
    }
    ASSERT_EQ(rig.plan(test::kReady, chain), CartesianPlanner::Progress::kDone);
    const CartesianPlan& plan = rig.planner.plan();
    // The ramps take 0.02 s and, smoothed, 0.03 s.
    const auto ramp = static_cast<std::int64_t>(0.04 / kTickSeconds);
    double slowest = 1e9;
    for (std::int64_t tick = ramp; tick < plan.duration.value() - ramp; ++tick) {
      const auto place = [&](std::int64_t k) {
        return tool_pose(plan, static_cast<double>(k) * kTickSeconds).position_mm;
      };
      slowest = std::min(slowest, (place(tick + 1) - place(tick)).norm() / kTickSeconds);
    }
    EXPECT_GT(slowest, 0.98 * limits.speed_mm_s);
  }
}

}  // namespace
}  // namespace armature
