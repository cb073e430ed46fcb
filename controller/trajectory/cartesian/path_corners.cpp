#include "controller/trajectory/cartesian/path_corners.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "controller/base/math.hpp"
#include "controller/kinematics/turns.hpp"

namespace armature {
namespace {

// B of cartesian_plan.hpp in the middle of a corner: the corner point is missed by 2 c times this for each unit that
// the direction changes.
constexpr double kCornerMiddle = 0.09375;
constexpr double kLeastMoveShare = 1e-4;
// A larger change of direction, more than 169 degrees, is a reversal: the tool rests there in any case.
constexpr double kReversal = 1.99;
constexpr double kNoChange_rad = 1e-9, kNoChange = 1e-6;
constexpr int kCornerHalvings = 40;
constexpr int kCornerSamples = 8;   // of a corner
constexpr int kCurveSamples = 128;  // of a path

double change_of_direction(const CartesianSegment& first, const CartesianSegment& second) {
  const PathDirection a = direction_at(first, 1.0), b = direction_at(second, 0.0);
  return std::max((b.move - a.move).norm(), kTurnLever_mm * (b.turn_per_mm - a.turn_per_mm).norm());
}

// True when the parameter is the length. Where the tool almost only rotates, a length has too few digits for it.
bool is_move(const CartesianSegment& segment) {
  return has_length(segment) && segment.path.length_mm >= kLeastMoveShare * kTurnLever_mm * turn_angle_rad(segment);
}

// With limited jerk a smooth joint is passed slowly where the direction or the curvature jumps.
bool jerks(const CartesianSegment& first, const CartesianSegment& second) {
  if (first.profile != ProfileKind::kSCurve && second.profile != ProfileKind::kSCurve) return false;
  const Eigen::Vector3d before = bend_at(first, 1.0), after = bend_at(second, 0.0);
  return change_of_direction(first, second) > kNoChange_rad || (after - before).norm() > kNoChange * before.norm();
}

bool reverses(const CartesianSegment& first, const CartesianSegment& second) {
  return (direction_at(second, 0.0).move - direction_at(first, 1.0).move).norm() > kReversal;
}

bool may_pass(const CartesianSegment& first, const CartesianSegment& second) {
  const bool alike = (first.turning == Turning::kFollowing) == (second.turning == Turning::kFollowing);
  return alike && is_move(first) && is_move(second) && !reverses(first, second);
}

// Of a point near the path, by halving the steps of a search from the nearest of its samples.
double distance_to_curve_mm(const Eigen::Vector3d& point_mm, const PositionPath& path) {
  const auto off = [&](double share) { return (point(path, share) - point_mm).norm(); };
  double best = 0.0, least = off(0.0), step = 1.0 / kCurveSamples;
  for (int i = 1; i <= kCurveSamples; ++i) {
    const double share = static_cast<double>(i) * step, mm = off(share);
    if (mm < least) best = share, least = mm;
  }
  for (int i = 0; i < kCornerHalvings; ++i, step *= 0.5) {
    for (const double share : {best - step, best + step}) {
      if (const double mm = off(share); mm < least) best = share, least = mm;
    }
  }
  return least;
}

double distance_mm(const Eigen::Vector3d& point_mm, const PositionPath& path) {
  const double to_ends = std::min((point_mm - path.start_mm).norm(), (point_mm - path.end_mm).norm());
  if (path.shape == PositionPath::Shape::kLine) {
    const Eigen::Vector3d along = tangent(path, 0.0), from_start = point_mm - path.start_mm;
    const double covered = along.dot(from_start);
    return covered > 0.0 && covered < path.length_mm ? (from_start - covered * along).norm() : to_ends;
  }
  if (path.shape == PositionPath::Shape::kSpline || path.advance_mm != 0.0) return distance_to_curve_mm(point_mm, path);
  const Eigen::Vector3d arm = point_mm - path.center_mm;
  const double x = arm.dot(path.x), y = arm.dot(path.y), z = arm.dot(path.x.cross(path.y));
  double phi = math::atan2(y, x);
  if (phi < 0.0) phi += kTurn_rad;
  return phi <= path.angle_rad || path.angle_rad >= kTurn_rad ? math::hypot(math::hypot(x, y) - path.radius_mm, z)
                                                              : to_ends;
}

// How far the rounded corner leaves the path, from samples.
double deviation_mm(const CartesianSegment& first, const CartesianSegment& second, double c) {
  double most = 0.0;
  for (int k = 1; k < kCornerSamples; ++k) {
    const CornerShares shares = corner_shares(first, second, c, static_cast<double>(k) / kCornerSamples);
    const Eigen::Vector3d p =
        point(first.path, shares.first) + point(second.path, shares.second) - second.path.start_mm;
    const double off = 2 * k == kCornerSamples ? (p - second.path.start_mm).norm()
                                               : std::min(distance_mm(p, first.path), distance_mm(p, second.path));
    most = std::max(most, off);
  }
  return most;
}

// c of the corner that deviates by blend_mm.
double corner_of(const CartesianSegment& first, const CartesianSegment& second, double blend_mm) {
  const double longest = 0.5 * std::min(first.length, second.length);
  const double straight = 0.5 * blend_mm / kCornerMiddle / change_of_direction(first, second);
  const auto line = [](const CartesianSegment& s) { return s.path.shape == PositionPath::Shape::kLine; };
  double high = std::min(longest, straight);
  if (line(first) && line(second)) return high;
  // On arcs the tangents change along the corner as well.
  if (deviation_mm(first, second, high) <= blend_mm) return high;
  double low = 0.0;
  for (int i = 0; i < kCornerHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (deviation_mm(first, second, middle) <= blend_mm ? low : high) = middle;
  }
  return low;
}

void lay_out_lengths(CartesianPlan& plan, std::size_t first) {
  double from = first == 0 ? 0.0 : plan.segments[first - 1].from + plan.segments[first - 1].length;
  for (std::size_t i = first; i < plan.count; ++i) {
    CartesianSegment& segment = plan.segments[i];
    segment.from = from;
    segment.length = is_move(segment)    ? segment.path.length_mm
                     : is_empty(segment) ? 0.0
                                         : turn_angle_rad(segment) * kTurnLever_mm;
    segment.corner = 0.0;
    from += segment.length;
  }
}

void round_corner(CartesianPlan& plan, std::size_t index, double blend_mm) {
  CartesianSegment& first = plan.segments[index];
  const CartesianSegment& second = plan.segments[index + 1];
  if (!(blend_mm > 0.0) || !may_pass(first, second)) return;
  if (joint_after(plan, index) == PathJoint::kSmooth && !jerks(first, second)) return;
  first.corner = corner_of(first, second, blend_mm);
}

}  // namespace

PathDirection direction_at(const CartesianSegment& segment, double share) noexcept {
  PathDirection result;
  if (!(segment.length > 0.0)) return result;
  result.move = tangent(segment.path, share) * (segment.path.length_mm / segment.length);
  if (segment.turning == Turning::kFollowing) {
    const PlaneAngles& change = segment.plane_turn.change;
    result.turn_per_mm = Eigen::Vector3d{change.pitch_rad, change.roll_rad, 0.0} / segment.length;
  } else {
    const OrientationPath& turn = segment.orientation;
    result.turn_per_mm = turn.start * turn.axis * (turn.angle_rad / segment.length);
  }
  return result;
}

Eigen::Vector3d bend_at(const CartesianSegment& segment, double share) noexcept {
  const PositionPath& path = segment.path;
  if (path.shape == PositionPath::Shape::kLine || !(segment.length > 0.0)) return Eigen::Vector3d::Zero();
  if (path.shape == PositionPath::Shape::kSpline) {
    const double scale = path.length_mm / segment.length;
    return path.spline->at(share * path.length_mm).bend * (scale * scale);
  }
  const double around = path.angle_rad / segment.length;
  const math::SinCos phi = math::sin_cos(share * path.angle_rad);
  return -(phi.cos * path.x + phi.sin * path.y) * (path.radius_mm * around * around);
}

PathJoint joint_after(const CartesianPlan& plan, std::size_t first) noexcept {
  if (plan.segments[first].corner > 0.0) return PathJoint::kRounded;
  const CartesianSegment &a = plan.segments[first], &b = plan.segments[first + 1];
  return may_pass(a, b) && change_of_direction(a, b) <= kSmooth_rad ? PathJoint::kSmooth : PathJoint::kStop;
}

void lay_out_corners(CartesianPlan& plan, std::span<const SegmentRequest> chain, bool rounds) noexcept {
  lay_out_lengths(plan, 0);
  for (std::size_t i = 0; rounds && i + 1 < plan.count; ++i) round_corner(plan, i, chain[i].blend_mm);
}

void add_corners(CartesianPlan& plan, std::size_t last, double blend_mm, double longest,
                 std::span<const SegmentRequest> added) noexcept {
  lay_out_lengths(plan, last + 1);
  round_corner(plan, last, blend_mm);
  plan.segments[last].corner = std::min(plan.segments[last].corner, longest);
  for (std::size_t i = 0; i + 1 < added.size(); ++i) round_corner(plan, last + 1 + i, added[i].blend_mm);
}

}  // namespace armature
