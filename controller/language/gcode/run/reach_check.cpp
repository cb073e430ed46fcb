#include "controller/language/gcode/run/reach_check.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/base/angle_units.hpp"
#include "controller/base/math.hpp"
#include "controller/base/rounding.hpp"
#include "controller/cell/frames.hpp"

namespace armature::gcode {
namespace {

constexpr double kBetween_mm = 5.0;
constexpr double kBetween_rad = 0.05;
constexpr int kMaxSamples = 10'000;

// A rotation on the way from one to another. Near a half turn it is far from the shortest way.
Eigen::Matrix3d between(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to, double share) noexcept {
  const Eigen::Matrix3d mixed = (1.0 - share) * from + share * to;
  const Eigen::Vector3d z = mixed.col(2).normalized();
  const Eigen::Vector3d x = (mixed.col(0) - z.dot(mixed.col(0)) * z).normalized();
  Eigen::Matrix3d rotation;
  rotation.col(0) = x;
  rotation.col(1) = z.cross(x);
  rotation.col(2) = z;
  return rotation;
}

// `-12.5` for -125.
void append_tenths(FixedText<64>& text, std::int64_t tenths) noexcept {
  const auto size = static_cast<std::uint64_t>(tenths < 0 ? -tenths : tenths);
  text << (tenths < 0 ? std::string_view{"-"} : std::string_view{});
  text.append_digits(size / 10, 1);
  (text << '.').append_digits(size % 10, 1);
}

}  // namespace

void ReachCheck::begin(const JointAngles& joints) noexcept {
  joints_ = joints;
  base_T_tool_ = setup_.cell.arm.forward(joints) * setup_.cell.flange_T_tool;
  sample_ = samples_ = 0;
  reach_problem_.reset();
}

void ReachCheck::add(const CartesianMove& move) noexcept {
  move_ = move;
  const Transform base_T_user = base_T_frame(move.target.frame, setup_.cell.base_T_user, base_T_tool_);
  frame_T_from_ = inverse(base_T_user) * base_T_tool_;
  double length = (move.target.position_mm - frame_T_from_.position_mm).norm();
  double angle = 0.0;
  if (move.kind == SegmentRequest::Kind::kArcAbout) {
    const Eigen::Vector3d arm = frame_T_from_.position_mm - move.via_mm;
    angle = std::fabs(move.about.angle_rad);
    length = math::hypot(arm.norm() * angle, move.about.advance_mm);
  }
  if (move.target.rotation) {
    angle += 2.0 * (*move.target.rotation - frame_T_from_.rotation).norm();  // at least the angle
  }
  const double wanted = std::max({1.0, length / kBetween_mm, angle / kBetween_rad});
  samples_ = static_cast<int>(std::min(wanted, static_cast<double>(kMaxSamples))) + 1;
  sample_ = 0;
}

Transform ReachCheck::pose(double share) const noexcept {
  FramedPose pose = move_.target;
  if (move_.kind == SegmentRequest::Kind::kArcAbout) {
    const Eigen::Vector3d axis = move_.about.axis.normalized();
    const Eigen::Vector3d arm = frame_T_from_.position_mm - move_.via_mm;
    const Eigen::Vector3d along = axis.dot(arm) * axis;
    const math::SinCos turn = math::sin_cos(share * move_.about.angle_rad);
    pose.position_mm = move_.via_mm + along + turn.cos * (arm - along) + turn.sin * axis.cross(arm) +
                       share * move_.about.advance_mm * axis;
  } else {
    pose.position_mm = frame_T_from_.position_mm + share * (move_.target.position_mm - frame_T_from_.position_mm);
  }
  if (pose.rotation) pose.rotation = between(frame_T_from_.rotation, *move_.target.rotation, share);
  return resolve(pose, setup_.cell.base_T_user, base_T_tool_, plane_, move_.kind == SegmentRequest::Kind::kLine);
}

std::optional<ReachCheck::Problem> ReachCheck::work(int max_samples) noexcept {
  const Transform tool_T_flange = inverse(setup_.cell.flange_T_tool);
  inverses_ = 0;
  while (inverses_ < max_samples && busy()) {
    ++inverses_;
    ++sample_;
    const Transform base_T_tool = pose(static_cast<double>(sample_) / samples_);
    const IkTracking found = setup_.cell.arm.track_keeping_elbow(base_T_tool * tool_T_flange, joints_);
    if (found.status == IkStatus::kUnreachable && found.found) {
      // The rest of the move tells how far it leaves the reach.
      const double before_mm = reach_problem_ ? reach_problem_->margin_mm : 0.0;
      reach_problem_ = Problem{.status = found.status, .margin_mm = std::max(before_mm, found.margin_mm)};
    } else if (!solved(found.status) && !reach_problem_) {
      const double angle_rad = found.axis == 0 ? 0.0 : found.joints[found.axis - 1U].value();
      return Problem{.status = found.status, .axis = found.axis, .angle_rad = angle_rad, .margin_mm = found.margin_mm};
    }
    if (found.found) joints_ = found.joints;
    if (busy()) continue;
    if (reach_problem_) return std::exchange(reach_problem_, std::nullopt);
    base_T_tool_ = base_T_tool;
  }
  return std::nullopt;
}

FixedText<64> ReachCheck::text_of(const Problem& problem) const noexcept {
  FixedText<64> text;
  if (problem.status == IkStatus::kOutsideLimits) {
    const double limit_rad = setup_.cell.robot.axes[problem.axis - 1U].nearer_limit_rad(problem.angle_rad);
    const auto up = static_cast<std::int64_t>(rounded_up(10.0 * kDegPerRad * std::fabs(problem.angle_rad)));
    text << "the path needs joint " << static_cast<std::uint32_t>(problem.axis) << " at ";
    append_tenths(text, problem.angle_rad < 0.0 ? -up : up);
    text << " deg, its limit is ";
    append_tenths(text, round_half_away(10.0 * kDegPerRad * limit_rad));
    text << " deg";
  } else if (problem.status == IkStatus::kOrientation) {
    text << "the arm cannot hold the tool in this orientation";
  } else {
    text << "the path leaves the reach of the arm by up to " << static_cast<int>(rounded_up(problem.margin_mm))
         << " mm";
  }
  return text;
}

}  // namespace armature::gcode
