#include "controller/activity/plans/stages/path_requests.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "controller/trajectory/cartesian/path_corners.hpp"
#include "controller/trajectory/path/orientation_path.hpp"
#include "controller/trajectory/path/position_path.hpp"

namespace armature {
namespace {

// Unit vector at the start of a request; 0 if it has no length or is no circle.
Eigen::Vector3d first_direction(const SegmentRequest& request, const Eigen::Vector3d& from_mm) {
  Spline curve;
  const std::optional<PositionPath> path = path_of(request, from_mm, curve);
  return path ? tangent(*path, 0.0) : Eigen::Vector3d::Zero();
}

// The angle between both is at least this: twice the sine of half of it.
double least_turn_rad(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  return (to - from).norm() / std::sqrt(2.0);
}

}  // namespace

bool PathRequests::accepts(const CartesianMove& move, const UserFrames& base_T_user,
                           const ArmPlane& plane) const noexcept {
  if (count_ == 0) return true;
  if (count_ >= CartesianPlan::kMaxFirstSegments) return false;
  if (move.kind == SegmentRequest::Kind::kSpline && spline_count_ == splines_.size()) return false;
  if (output_count_ + move.outputs.count > TimedOutputs::kMax) return false;
  return continues_with(move, base_T_user, plane);
}

bool PathRequests::continues() const noexcept {
  return count_ < requests_.size() && !last_stops_ && (last_blend_mm_ > 0.0 || !last_direction_.isZero(0.0));
}

bool PathRequests::continues_with(const CartesianMove& move, const UserFrames& base_T_user,
                                  const ArmPlane& plane) const noexcept {
  if (!continues()) return false;
  if (last_blend_mm_ > 0.0) return true;
  ThroughPoints through;
  const Eigen::Vector3d next = first_direction(request_of(move, base_T_user, plane, through), end_.position_mm);
  return !next.isZero(0.0) && (next - last_direction_).norm() <= kSmooth_rad;
}

void PathRequests::restart(const Transform& base_T_tool) noexcept {
  clear();
  end_ = base_T_tool;
  last_blend_mm_ = blend_before_mm_ = 0.0;
}

void PathRequests::drop_front(std::size_t count) noexcept {
  if (count == 0) return;
  blend_before_mm_ = count < count_ ? requests_[count - 1].blend_mm : last_blend_mm_;
  std::copy(requests_.begin() + static_cast<std::ptrdiff_t>(count),
            requests_.begin() + static_cast<std::ptrdiff_t>(count_), requests_.begin());
  const double dropped_s = least_s(count);
  for (std::size_t i = count; i < count_; ++i) least_s_[i - count] = least_s_[i] - dropped_s;
  count_ -= count;
}

void PathRequests::add(const CartesianMove& move, const UserFrames& base_T_user, const ArmPlane& plane) noexcept {
  if (count_ > 0) requests_[count_ - 1].blend_mm = last_blend_mm_;
  SegmentRequest& request = requests_[count_++];
  request = request_of(move, base_T_user, plane, splines_[spline_count_ % splines_.size()]);
  if (move.kind == SegmentRequest::Kind::kSpline) ++spline_count_;
  output_count_ += move.outputs.count;
  last_blend_mm_ = move.blend_mm;
  last_stops_ = move.exact_stop;
  Spline curve;
  const std::optional<PositionPath> path = path_of(request, end_.position_mm, curve);
  last_direction_ = path ? tangent(*path, 1.0) : Eigen::Vector3d::Zero();
  const double turn_rad = least_turn_rad(end_.rotation, request.target.rotation);
  const double added_s =
      std::max((path ? path->length_mm : 0.0) / request.limits.speed_mm_s, turn_rad / request.limits.turn_speed_rad_s);
  least_s_[count_ - 1] = least_s(count_ - 1) + added_s;
  end_.rotation = request.target.rotation;
  // A circle ends at its start point, whatever the orientation does.
  if (move.kind != SegmentRequest::Kind::kCircle) end_.position_mm = request.target.position_mm;
}

std::size_t PathRequests::count_with_outputs(std::size_t most) const noexcept {
  std::size_t count = 0, outputs = 0;
  while (count < count_ && (outputs += requests_[count].outputs.count) <= most) ++count;
  return count;
}

void PathRequests::slow_down(const PathLimits& most) noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    PathLimits& limits = requests_[i].limits;
    if (most.speed_mm_s > 0.0) limits.speed_mm_s = std::min(limits.speed_mm_s, most.speed_mm_s);
    if (most.accel_mm_s2 > 0.0) limits.accel_mm_s2 = std::min(limits.accel_mm_s2, most.accel_mm_s2);
  }
}

SegmentRequest PathRequests::request_of(const CartesianMove& move, const UserFrames& base_T_user, const ArmPlane& plane,
                                        ThroughPoints& through) const noexcept {
  const Transform frame = base_T_frame(move.target.frame, base_T_user, end_);
  SegmentRequest request{
      .kind = move.kind,
      .via_mm = frame * move.via_mm,
      .about = move.about,
      .target = resolve(move.target, base_T_user, end_, plane, move.kind == SegmentRequest::Kind::kLine),
      .keeps_orientation = !move.target.rotation,
      .limits = move.limits,
      .profile = move.profile,
      .at_singularity = move.at_singularity,
      .orientation_tolerance_rad = move.orientation_tolerance_rad,
      .configuration = move.target.configuration,
      .outputs = move.outputs,
      .rapid = move.rapid,
      .tag = move.tag};
  if (move.kind == SegmentRequest::Kind::kSpline) {
    through.count = move.through.count;
    for (std::size_t i = 0; i < through.count; ++i) through.mm[i] = frame * move.through.mm[i];
    request.through_mm = through.view();
  }
  const bool is_arc_about = move.kind == SegmentRequest::Kind::kArcAbout;
  const bool follows_tangent = move.orientation == CartesianMove::Orientation::kTangent;
  if (is_arc_about) request.about.axis = frame.rotation * move.about.axis;
  Spline unused;
  std::optional<PositionPath> path;  // without one the planner reports why
  if (is_arc_about || follows_tangent) path = path_of(request, end_.position_mm, unused);
  if (is_arc_about) request.target.position_mm = path ? path->end_mm : end_.position_mm;

  const bool is_circle = move.kind == SegmentRequest::Kind::kCircle;
  const bool is_slerp = move.orientation == CartesianMove::Orientation::kSlerp;
  if (!move.target.rotation) {
    if (is_arc_about) request.target.rotation = plane.kept(end_, request.target.position_mm, false);
    if (is_circle || is_slerp) request.target.rotation = end_.rotation;
  }
  if (is_slerp) request.turning = SegmentRequest::Turning::kSlerp;
  if (follows_tangent) request.turning = SegmentRequest::Turning::kTangent;
  if (follows_tangent && path) request.target.rotation = turn_with(*path, end_.rotation).end;
  return request;
}

}  // namespace armature
