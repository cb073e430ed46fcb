// From the numbers of the pendant to commands of the dispatcher: jogs, increments and moves in the selected
// coordinates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/cell/planning_config.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/command.hpp"
#include "controller/pendant/parts/pressed_axes.hpp"
#include "controller/pendant/parts/staged_move.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature::pendant {

// The largest speed of the tool in manual operation, in mm/s: that of ISO 10218-1.
inline constexpr double kToolSpeed = 250.0;

class Coordinates {
 public:
  // References must outlive the object.
  Coordinates(const RobotModel& robot, const Arm& arm, const PlanningConfig& config) noexcept;

  void select(System system) noexcept { system_ = system; }
  void select_user(std::uint8_t frame) noexcept { user_ = FrameId{frame}; }
  [[nodiscard]] System system() const noexcept { return system_; }
  // The selected user frame; none with other coordinates.
  [[nodiscard]] std::optional<FrameId> user_frame() const noexcept {
    if (system_ != System::kUser) return std::nullopt;
    return user_;
  }
  // False: the selected user frame is not defined.
  [[nodiscard]] bool defined() const noexcept {
    return is_known(user_frame().value_or(kBaseFrame), config_.base_T_user);
  }
  // Number of coordinates of a point.
  [[nodiscard]] std::size_t count() const noexcept;

  // `scale`: the share of the largest speeds that a fully pressed key has.
  [[nodiscard]] Jog jog(const PressedAxes& pressed, double scale, Cycles now) const noexcept;
  // A move of one axis by a distance, from where the arm stands.
  [[nodiscard]] Command increment(std::size_t axis, std::int32_t distance, double scale,
                                  const PerAxis<Radians>& present) const noexcept;

  [[nodiscard]] Command joint_move(const StagedMove& staged) const noexcept;
  [[nodiscard]] Command line(const StagedMove& staged) const noexcept;
  [[nodiscard]] Command arc(const StagedMove& staged) const noexcept;

  // For telemetry: pulses of a joint; X Y Z Rx Ry Rz of the tool in the base frame, 0 without kinematics.
  [[nodiscard]] std::int32_t pulses(std::size_t axis, const PerAxis<Radians>& joints) const noexcept;
  [[nodiscard]] StagedMove::Point tool(const PerAxis<Radians>& joints) const noexcept;

 private:
  [[nodiscard]] FrameId frame() const noexcept;
  [[nodiscard]] PerAxis<Radians> joints_of(const StagedMove::Point& point) const noexcept;
  [[nodiscard]] FramedPose pose_of(const StagedMove::Point& point) const noexcept;
  [[nodiscard]] CartesianMove path(const StagedMove& staged, std::size_t end) const noexcept;

  const RobotModel& robot_;
  const Arm& arm_;
  const PlanningConfig& config_;
  System system_ = System::kJoints;
  FrameId user_{1};
};

}  // namespace armature::pendant
