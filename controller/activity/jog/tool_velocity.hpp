// Set-points of an arm whose tool has a commanded velocity: the Cartesian part of the velocity source.
//
// The tool changes from its present velocity to the commanded one in a straight line between both (of velocities in the
// frame of the command), as fast as its acceleration limits and a share of those of the joints allow. A change that
// comes during another one begins with its acceleration (velocity_change.hpp), a tick later: there is no time for the
// whole of it in one tick. The joints follow by inverse kinematics,
// so a constant velocity is a straight line of the tool. All joints together slow down where one of them needs it: at
// its speed limit, and before its soft limit, where the tool comes to rest with the joint exactly at its limit.
//
// Some motions cannot continue along the path within the limits of the joints: into a singularity, or beyond the reach,
// faster than the joints can brake along the path. Then there is no next set-point, and the caller stops the joints,
// each for itself. For this every joint always keeps its braking distance. kSixR only.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "controller/activity/jog/velocity_change.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/tool_velocity_limits.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/state/axis_reach.hpp"

namespace armature {

// The velocity of the tool centre point. A command in a user frame is one in the base frame, rotated.
struct ToolTwist {
  enum class Frame : std::uint8_t { kBase, kTool };  // kTool: the axes turn with the tool

  Frame frame = Frame::kBase;
  Eigen::Vector3d move_mm_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn_rad_s = Eigen::Vector3d::Zero();

  [[nodiscard]] bool is_zero() const noexcept {
    return move_mm_s == Eigen::Vector3d::Zero() && turn_rad_s == Eigen::Vector3d::Zero();
  }
  [[nodiscard]] bool operator==(const ToolTwist& other) const noexcept {
    return frame == other.frame && move_mm_s == other.move_mm_s && turn_rad_s == other.turn_rad_s;
  }
};

class ToolVelocity {
 public:
  // References must outlive the object.
  ToolVelocity(const RobotModel& robot, const Arm& arm, const ToolVelocityLimits& limits,
               const Transform& flange_T_tool) noexcept;

  // The arm is at rest at `position`, without a command.
  void begin(const PerAxis<Radians>& position) noexcept;

  // For the changes of velocity from now on.
  void set_limits(const ToolVelocityLimits& limits) noexcept { limits_ = limits; }
  // The wanted velocity from now on; finite.
  void follow(const ToolTwist& twist) noexcept;
  // Instead: come to rest along the path with nearly the full acceleration of the joints.
  void stop() noexcept {
    stopping_ = true;
    next_change_.reset();
  }

  // The set-point of the next tick. None: the joints must stop; begin() follows when they are at rest.
  [[nodiscard]] std::optional<PerAxis<Radians>> advance() noexcept;

  // The last step was 0, and the commanded velocity is 0 or cannot be followed.
  [[nodiscard]] bool at_rest() const noexcept { return at_rest_; }
  [[nodiscard]] const ToolTwist& wanted() const noexcept { return wanted_; }
  [[nodiscard]] bool wants_to_move() const noexcept { return !wanted_.is_zero(); }
  // The first joint that stands at one of its soft limits, 1..6; 0: none.
  [[nodiscard]] std::uint8_t axis_at_limit() const noexcept;
  [[nodiscard]] PerAxis<AxisState> state() const noexcept;
  // Inverse kinematics computed by the last advance().
  [[nodiscard]] int inverses() const noexcept { return inverses_; }

 private:
  using Vector6 = VelocityChange::Twist;

  // A velocity in the base as one in the frame of the command, where the tool has these axes; and back, for the tool
  // where it is now.
  [[nodiscard]] static Vector6 in_frame(const Vector6& twist, const Eigen::Matrix3d& base_R_tool,
                                        ToolTwist::Frame frame) noexcept;
  [[nodiscard]] Vector6 in_base(const Vector6& twist, ToolTwist::Frame frame) const noexcept;
  [[nodiscard]] Vector6 wanted_twist() const noexcept;
  [[nodiscard]] VelocityChange::Limits limits_of_change() const noexcept;
  void change_at_once() noexcept;
  void begin_next_change() noexcept;
  void end_of_next_change() noexcept;
  void start_change(bool planned) noexcept;
  [[nodiscard]] VelocityChange::Change change_of(const Vector6& in_frame) noexcept;
  [[nodiscard]] PerAxis<double> rates(const Vector6& twist) noexcept;
  [[nodiscard]] std::optional<double> share_of(const PerAxis<double>& rates_rad_s) const noexcept;
  [[nodiscard]] bool allowed(const PerAxis<Radians>& next) const noexcept;
  void move_reference(const Vector6& twist, double duration_s) noexcept;

  const RobotModel& robot_;
  const Arm& arm_;
  ToolVelocityLimits limits_;
  Transform flange_T_tool_, tool_T_flange_;
  PerAxis<double> max_speed_rad_s_{};
  PerAxis<Radians> position_{}, previous_{}, before_{};
  std::optional<SixRPosture> posture_{};  // of position_, once it was needed
  Transform base_T_tool_{};               // of position_, without the rounding of the inverse kinematics
  // Of the latest set-point: the velocity in the base, and the axes of the tool that it was for.
  struct Moving {
    Vector6 twist = Vector6::Zero();
    Eigen::Matrix3d base_R_tool = Eigen::Matrix3d::Identity();
    bool whole = true;  // the joints did not slow it down
  };
  Moving moving_{};
  ToolTwist wanted_{};
  VelocityChange change_{};
  ToolTwist::Frame change_frame_{};  // of its velocities
  std::int64_t change_ticks_ = 0;
  std::optional<VelocityChange> next_change_{};  // to `wanted_`, in its frame; begins after the next tick
  bool is_due_ = false;                          // that tick is over
  bool stopping_ = false;
  bool at_rest_ = true;
  int inverses_ = 0;
};

}  // namespace armature
