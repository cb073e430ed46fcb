#include "controller/activity/move_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "controller/base/misfit.hpp"
#include "controller/drivers/axi_gpio.hpp"
#include "controller/kinematics/turns.hpp"
#include "controller/trajectory/joint/joint_move.hpp"

namespace armature {
namespace {

constexpr double kMinOverride = 0.01;

// Each check is written so that a NaN fails it.

bool is_share(double speed) {
  return speed > 0.0 && speed <= 1.0;
}

bool is_blend(const JointBlend& blend) {
  const bool valid = blend.rad >= 0.0 && std::isfinite(blend.rad) && blend.share >= 0.0 && blend.share <= 1.0;
  return valid && !(blend.rad > 0.0 && blend.share > 0.0);
}

bool is_pin(std::uint8_t pin) {
  return pin >= 1 && pin <= AxiGpio::kPins;
}

bool is_finite(const Eigen::Vector3d& v) {
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

bool is_pose(const FramedPose& pose, const UserFrames& base_T_user) {
  const Eigen::Matrix3d rotation = pose.rotation ? *pose.rotation : Eigen::Matrix3d::Identity();
  return is_known(pose.frame, base_T_user) && is_rigid({rotation, pose.position_mm});
}

bool has_configuration(const RobotModel& robot, const Configuration& wanted) {
  if (wanted.wrist != WristSide::kNearest && robot.arm.family != ArmFamily::kSixR) return false;
  if (!wanted.turns) return true;
  return std::all_of(wanted.turns->begin() + static_cast<std::ptrdiff_t>(robot.axis_count), wanted.turns->end(),
                     [](std::int8_t turns) { return turns == 0; });
}

bool has_orientation(const CartesianMove& move) {
  using enum CartesianMove::Orientation;
  if (move.kind == SegmentRequest::Kind::kSpline && move.orientation == kTangent) return false;
  return move.orientation == kSteady || move.orientation == kSlerp || !move.target.rotation;
}

bool has_tolerance(const CartesianMove& move) {
  if (move.at_singularity != AtSingularity::kBend) return true;
  return move.orientation_tolerance_rad > 0.0 && move.orientation_tolerance_rad <= CartesianMove::kMaxTolerance_rad;
}

bool are_positive(const PathLimits& limits, ProfileKind profile) {
  return is_positive(limits.speed_mm_s) && is_positive(limits.accel_mm_s2) && is_positive(limits.turn_speed_rad_s) &&
         is_positive(limits.turn_accel_rad_s2) && is_share(limits.joint_accel) &&
         (profile != ProfileKind::kSCurve || (is_positive(limits.jerk_mm_s3) && is_positive(limits.turn_jerk_rad_s3)));
}

bool are_positive(const ToolVelocityLimits& limits, ProfileKind profile) {
  return is_positive(limits.accel_mm_s2) && is_positive(limits.turn_accel_rad_s2) &&
         (profile != ProfileKind::kSCurve || (is_positive(limits.jerk_mm_s3) && is_positive(limits.turn_jerk_rad_s3)));
}

bool is_valid(const AboutAxis& about) {
  return is_finite(about.axis) && std::isfinite(about.advance_mm) &&
         std::fabs(about.angle_rad) <= kMaxRevolutions * kTurn_rad;
}

// The points of a spline: at least one.
bool is_valid(const ThroughPoints& through) {
  if (through.count == 0 || through.count > ThroughPoints::kMax) return false;
  return std::all_of(through.mm.begin(), through.mm.begin() + through.count, is_finite);
}

bool is_valid(const PathOutputs& outputs) {
  if (outputs.count > PathOutputs::kMax) return false;
  return std::all_of(outputs.list.begin(), outputs.list.begin() + outputs.count,
                     [](const PathOutput& output) { return is_pin(output.pin) && std::isfinite(output.offset); });
}

// Of a joint move: in time only.
bool are_timed(const PathOutputs& outputs) {
  return is_valid(outputs) &&
         std::all_of(outputs.list.begin(), outputs.list.begin() + outputs.count,
                     [](const PathOutput& output) { return output.unit == PathOutput::Unit::kSeconds; });
}

void name_limit(const AxisModel& axis, PathProblem& problem) {
  problem.limit_rad = axis.nearer_limit_rad(problem.angle_rad);
  const bool inside = problem.angle_rad >= axis.min_rad && problem.angle_rad <= axis.max_rad;
  if (inside) problem.angle_rad = problem.limit_rad;
}

MoveRefused invalid(std::uint8_t axis = 0) {
  return {.reason = Refusal::kInvalidTarget, .axis = axis};
}

}  // namespace

std::optional<MoveRefused> find_profile_refusal(const RobotModel& robot, ProfileKind profile) noexcept {
  if (profile != ProfileKind::kSCurve) return std::nullopt;
  for (std::uint8_t axis = 0; axis < robot.axis_count; ++axis) {
    if (!(robot.axes[axis].max_jerk_rad_s3 > 0.0)) {
      return MoveRefused{.reason = Refusal::kNoJerkLimit, .axis = static_cast<std::uint8_t>(axis + 1)};
    }
  }
  return std::nullopt;
}

std::optional<MoveRefused> find_refusal(const RobotModel& robot, const PerAxis<double>& joints) noexcept {
  for (std::uint8_t axis = 0; axis < kAxes; ++axis) {
    const bool valid = axis < robot.axis_count ? std::isfinite(joints[axis]) : joints[axis] == 0.0;
    if (!valid) return invalid(static_cast<std::uint8_t>(axis + 1));
  }
  return std::nullopt;
}

std::optional<MoveRefused> find_refusal(const RobotModel& robot, const JointMove& move) noexcept {
  if (!is_share(move.speed) || !is_share(move.accel) || !is_blend(move.blend)) return invalid();
  if (!are_timed(move.outputs) || (move.now && move.outputs.count > 0)) return invalid();
  for (std::uint8_t axis = 0; axis < kAxes; ++axis) {
    const double target_rad = move.target[axis].value();
    const AxisModel& model = robot.axes[axis];
    const auto number = static_cast<std::uint8_t>(axis + 1);
    if (!std::isfinite(target_rad)) return invalid(number);
    if (axis >= robot.axis_count) {
      if (target_rad != 0.0) return invalid(number);
    } else if (target_rad < model.min_rad || target_rad > model.max_rad) {
      const PathProblem beyond{.at = 1.0, .angle_rad = target_rad, .limit_rad = model.nearer_limit_rad(target_rad)};
      return MoveRefused{.reason = Refusal::kOutsideLimits, .axis = number, .path = beyond};
    }
  }
  return find_profile_refusal(robot, move.profile);
}

std::optional<MoveRefused> find_refusal(const RobotModel& robot, const UserFrames& base_T_user,
                                        const PoseMove& move) noexcept {
  if (robot.arm.family == ArmFamily::kNone) return refused(Refusal::kNoKinematics);
  const bool valid = is_share(move.speed) && is_share(move.accel) && is_blend(move.blend) && are_timed(move.outputs) &&
                     is_pose(move.target, base_T_user) && move.target.frame != kConveyorFrame &&
                     has_configuration(robot, move.target.configuration);
  if (!valid) return invalid();
  return find_profile_refusal(robot, move.profile);
}

std::optional<MoveRefused> find_refusal(const RobotModel& robot, const UserFrames& base_T_user,
                                        const CartesianMove& move) noexcept {
  if (robot.arm.family == ArmFamily::kNone) return refused(Refusal::kNoKinematics);
  const bool has_via = move.kind != SegmentRequest::Kind::kLine && move.kind != SegmentRequest::Kind::kSpline;
  const bool valid = is_pose(move.target, base_T_user) && has_configuration(robot, move.target.configuration) &&
                     (!has_via || is_finite(move.via_mm)) && is_valid(move.about) &&
                     (move.kind != SegmentRequest::Kind::kSpline || is_valid(move.through)) && is_valid(move.outputs) &&
                     are_positive(move.limits, move.profile) && move.blend_mm >= 0.0 && std::isfinite(move.blend_mm) &&
                     !(move.exact_stop && move.blend_mm > 0.0) && has_tolerance(move) && has_orientation(move);
  if (!valid) return invalid();
  if (move.target.frame == kConveyorFrame) {
    if (move.kind == SegmentRequest::Kind::kSpline || move.outputs.count > 0) return invalid();
    if (robot.arm.family != ArmFamily::kSixR) return refused(Refusal::kOrientation);
  }
  return std::nullopt;
}

std::optional<MoveRefused> find_refusal(const Dwell& dwell) noexcept {
  if (dwell.duration > Ticks{} && dwell.duration <= kLongestMove) return std::nullopt;
  return invalid();
}

std::optional<MoveRefused> find_refusal(const SetOutput& output) noexcept {
  if (is_pin(output.pin)) return std::nullopt;
  return invalid();
}

std::optional<MoveRefused> find_refusal(const WaitInput& wait) noexcept {
  if (is_pin(wait.pin) && wait.timeout >= Ticks{} && wait.timeout <= kLongestMove) return std::nullopt;
  return invalid();
}

std::optional<MoveRefused> find_refusal(const RobotModel& robot, const UserFrames& base_T_user,
                                        const Jog& jog) noexcept {
  if (!(jog.duration > Ticks{}) || jog.duration > kLongestMove || !is_share(jog.accel_share)) return invalid();
  if (jog.kind == Jog::Kind::kTool) {
    if (robot.arm.family == ArmFamily::kNone) return refused(Refusal::kNoKinematics);
    if (robot.arm.family != ArmFamily::kSixR) return refused(Refusal::kOrientation);
    if (jog.frame == kConveyorFrame) return invalid();
    if (!is_known(jog.frame, base_T_user) || !is_finite(jog.move_mm_s) || !is_finite(jog.turn_rad_s)) return invalid();
    if (!are_positive(jog.tool, jog.profile)) return invalid();
    return std::nullopt;
  }
  if (const std::optional<MoveRefused> refusal = find_refusal(robot, jog.joint_rad_s)) return refusal;
  return find_profile_refusal(robot, jog.profile);
}

std::optional<MoveRefused> find_refusal(const RobotModel& robot, const Home& home) noexcept {
  for (std::uint8_t axis = 0; axis < 8; ++axis) {
    const bool exists = axis < robot.axis_count;
    const bool wanted = home.axes == 0 ? exists : ((home.axes >> axis) & 1u) != 0;
    if (wanted && !(exists && robot.axes[axis].homing)) {
      return MoveRefused{.reason = Refusal::kInvalidTarget, .axis = static_cast<std::uint8_t>(axis + 1)};
    }
  }
  return std::nullopt;
}

std::optional<MoveRefused> find_refusal(const SetOverride& wanted) noexcept {
  if (wanted.share >= kMinOverride && wanted.share <= 1.0) return std::nullopt;
  return invalid();
}

MoveRefused refusal_of(const RobotModel& robot, const PathProblem& problem) noexcept {
  MoveRefused refusal{.reason = Refusal::kInvalidTarget, .axis = problem.axis, .path = problem};
  switch (problem.kind) {
    case PathProblem::Kind::kNone:
    case PathProblem::Kind::kTooLong:
    case PathProblem::Kind::kTooManySegments:
    case PathProblem::Kind::kInvalidLimits:
    case PathProblem::Kind::kInvalidPose:
      break;
    case PathProblem::Kind::kNoCircle:
      refusal.reason = Refusal::kNoCircle;
      break;
    case PathProblem::Kind::kOutputOutside:
      refusal.reason = Refusal::kOutputOutside;
      break;
    case PathProblem::Kind::kNoSpline:
      refusal.reason = Refusal::kNoSpline;
      break;
    case PathProblem::Kind::kUnreachable:
      refusal.reason = Refusal::kUnreachable;
      break;
    case PathProblem::Kind::kOutsideLimits:
      refusal.reason = Refusal::kOutsideLimits;
      if (problem.axis != 0) name_limit(robot.axes[problem.axis - 1U], refusal.path);
      break;
    case PathProblem::Kind::kOrientation:
      refusal.reason = Refusal::kOrientation;
      break;
    case PathProblem::Kind::kNoConfiguration:
    case PathProblem::Kind::kOtherConfiguration:
      refusal.reason = Refusal::kConfiguration;
      break;
    case PathProblem::Kind::kTooFast:
      refusal.reason = problem.singular != kNotSingular ? Refusal::kSingular : Refusal::kTooFast;
      break;
  }
  return refusal;
}

MoveRefused refusal_of(const RobotModel& robot, const IkTracking& unsolved) noexcept {
  PathProblem problem{.kind = PathProblem::Kind::kUnreachable,
                      .at = 1.0,
                      .axis = unsolved.axis,
                      .margin_mm = unsolved.margin_mm,
                      .residual_rad = unsolved.residual_rad,
                      .angle_rad = unsolved.axis == 0 ? 0.0 : unsolved.joints[unsolved.axis - 1U].value(),
                      .configuration = unsolved.configuration};
  if (unsolved.status == IkStatus::kInvalidInput) problem = {};
  if (unsolved.status == IkStatus::kOutsideLimits) problem.kind = PathProblem::Kind::kOutsideLimits;
  if (unsolved.status == IkStatus::kOrientation) problem.kind = PathProblem::Kind::kOrientation;
  if (unsolved.status == IkStatus::kConfiguration) problem.kind = PathProblem::Kind::kNoConfiguration;
  return refusal_of(robot, problem);
}

}  // namespace armature
