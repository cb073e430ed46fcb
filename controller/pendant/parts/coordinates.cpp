#include "controller/pendant/parts/coordinates.hpp"

#include <Eigen/Core>
#include <numbers>
#include <optional>

#include "controller/base/rounding.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/robot/axis_units.hpp"

namespace armature::pendant {
namespace {

constexpr double kMmPerUnit = 1e-3, kRadPerUnit = 1e-4 * std::numbers::pi / 180.0;
constexpr double kToolTurn = std::numbers::pi / 4.0;  // rad/s
// A path takes a quarter of a second to its full speed.
constexpr double kToolAccel = 1'000.0, kToolTurnAccel = std::numbers::pi;  // mm/s^2, rad/s^2
constexpr double kTypicalShare = 0.25;                                     // of the speed, where the pendant gives none

std::int32_t units(double value, double per_unit) {
  return static_cast<std::int32_t>(round_half_away(value / per_unit));
}

Eigen::Vector3d position_of(const StagedMove::Point& point) {
  return kMmPerUnit *
         Eigen::Vector3d{static_cast<double>(point[0]), static_cast<double>(point[1]), static_cast<double>(point[2])};
}

Eigen::Matrix3d rotation_of(const StagedMove::Point& point) {
  return rotation_from_rpy(point[3] * kRadPerUnit, point[4] * kRadPerUnit, point[5] * kRadPerUnit);
}

}  // namespace

Coordinates::Coordinates(const RobotModel& robot, const Arm& arm, const PlanningConfig& config) noexcept
    : robot_{robot}, arm_{arm}, config_{config} {}

std::size_t Coordinates::count() const noexcept {
  return system_ == System::kJoints ? robot_.axis_count : StagedMove::kCoordinates;
}

FrameId Coordinates::frame() const noexcept {
  if (system_ == System::kTool) return kToolFrame;
  return system_ == System::kUser ? user_ : kBaseFrame;
}

Jog Coordinates::jog(const PressedAxes& pressed, double scale, Cycles now) const noexcept {
  Jog jog{.duration = kDeadMan};
  if (system_ == System::kJoints) {
    for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
      jog.joint_rad_s[axis] = pressed.share(axis, now) * scale * AxisUnits{robot_.axes[axis]}.max_speed_rad_s();
    }
    return jog;
  }
  jog.kind = Jog::Kind::kTool;
  jog.frame = frame();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    jog.move_mm_s[at] = pressed.share(axis, now) * scale * kToolSpeed;
    jog.turn_rad_s[at] = pressed.share(axis + 3, now) * scale * kToolTurn;
  }
  return jog;
}

Command Coordinates::increment(std::size_t axis, std::int32_t distance, double scale,
                               const PerAxis<Radians>& present) const noexcept {
  if (system_ == System::kJoints) {
    JointMove move{.target = present, .speed = scale};
    if (axis < robot_.axis_count) {
      move.target[axis] += Radians{distance * AxisUnits{robot_.axes[axis]}.rad_per_pulse()};
    }
    return move;
  }
  StagedMove::Point shift{};
  shift[axis] = distance;
  const Eigen::Matrix3d turned = rotation_of(shift);
  CartesianMove move{.limits = {.speed_mm_s = scale * kToolSpeed,
                                .accel_mm_s2 = kToolAccel,
                                .turn_speed_rad_s = scale * kToolTurn,
                                .turn_accel_rad_s2 = kToolTurnAccel}};
  move.target.frame = frame();
  if (system_ == System::kTool) {
    move.target.position_mm = position_of(shift);
    move.target.rotation = turned;
    return move;
  }
  Transform frame_T_tool = arm_.forward(present) * config_.flange_T_tool;
  const std::optional<Transform>* user =
      system_ == System::kUser ? &config_.base_T_user[user_.index - std::size_t{1}] : nullptr;
  if (user != nullptr && *user) frame_T_tool = inverse(**user) * frame_T_tool;
  move.target.position_mm = frame_T_tool.position_mm + position_of(shift);
  move.target.rotation = turned * frame_T_tool.rotation;
  return move;
}

Command Coordinates::joint_move(const StagedMove& staged) const noexcept {
  const double speed = staged.share(MoveOption::kSpeed, kTypicalShare),
               accel = staged.share(MoveOption::kAcceleration, 1.0);
  if (system_ == System::kJoints) {
    return JointMove{.target = joints_of(staged.point(0)), .speed = speed, .accel = accel};
  }
  return PoseMove{.target = pose_of(staged.point(0)), .speed = speed, .accel = accel};
}

Command Coordinates::line(const StagedMove& staged) const noexcept {
  return path(staged, 0);
}

Command Coordinates::arc(const StagedMove& staged) const noexcept {
  CartesianMove move = path(staged, 1);
  move.kind = SegmentRequest::Kind::kArc;
  move.via_mm = pose_of(staged.point(0)).position_mm;
  return move;
}

CartesianMove Coordinates::path(const StagedMove& staged, std::size_t end) const noexcept {
  const double speed = staged.share(MoveOption::kSpeed, kTypicalShare),
               accel = staged.share(MoveOption::kAcceleration, 1.0);
  return {.target = pose_of(staged.point(end)),
          .limits = {.speed_mm_s = speed * kToolSpeed,
                     .accel_mm_s2 = accel * kToolAccel,
                     .turn_speed_rad_s = speed * kToolTurn,
                     .turn_accel_rad_s2 = accel * kToolTurnAccel}};
}

PerAxis<Radians> Coordinates::joints_of(const StagedMove::Point& point) const noexcept {
  return make_per_axis([&](std::size_t axis) {
    return axis < robot_.axis_count ? Radians{point[axis] * AxisUnits{robot_.axes[axis]}.rad_per_pulse()} : Radians{};
  });
}

// A point in joints is the pose of the tool that they have.
FramedPose Coordinates::pose_of(const StagedMove::Point& point) const noexcept {
  FramedPose pose;
  if (system_ == System::kJoints) {
    const Transform base_T_tool = arm_.forward(joints_of(point)) * config_.flange_T_tool;
    pose.position_mm = base_T_tool.position_mm;
    pose.rotation = base_T_tool.rotation;
  } else {
    pose.frame = frame();
    pose.position_mm = position_of(point);
    pose.rotation = rotation_of(point);
  }
  return pose;
}

std::int32_t Coordinates::pulses(std::size_t axis, const PerAxis<Radians>& joints) const noexcept {
  if (axis >= robot_.axis_count) return 0;
  return static_cast<std::int32_t>(AxisUnits{robot_.axes[axis]}.to_pulses(joints[axis]).value());
}

StagedMove::Point Coordinates::tool(const PerAxis<Radians>& joints) const noexcept {
  if (!arm_.known()) return {};
  const Transform base_T_tool = arm_.forward(joints) * config_.flange_T_tool;
  const RollPitchYaw rpy = rpy_from_rotation(base_T_tool.rotation);
  const Eigen::Vector3d& mm = base_T_tool.position_mm;
  return {units(mm.x(), kMmPerUnit),        units(mm.y(), kMmPerUnit),         units(mm.z(), kMmPerUnit),
          units(rpy.roll_rad, kRadPerUnit), units(rpy.pitch_rad, kRadPerUnit), units(rpy.yaw_rad, kRadPerUnit)};
}

}  // namespace armature::pendant
