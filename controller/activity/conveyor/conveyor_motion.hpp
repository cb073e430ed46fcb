// The motion of an arm whose tool executes a path in a frame that moves with a belt.
//
// The frame of the path is an axis of its own, which follows the belt within an acceleration limit: it takes up the
// velocity of the belt, answers its changes, and comes to rest again. The tool is at the point of the path, shifted by
// the displacement of the frame; the joints follow by inverse kinematics. Every set-point is checked against the
// limits of the joints. Core 0 executes this motion; core 1 computes the same motion in advance for an assumed belt.
// kSixR only.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/cell/conveyor_config.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/state/axis_follower.hpp"

namespace armature {

class ConveyorMotion {
 public:
  // References must outlive the object. `limit_share`: of the limits of the joints.
  ConveyorMotion(const RobotModel& robot, const Arm& arm, const ConveyorConfig& config, const Transform& flange_T_tool,
                 double limit_share) noexcept;

  // The arm stands at `position`, and the frame stands at the displacement `frame_mm`.
  void begin(const PerAxis<Radians>& position, double frame_mm) noexcept;
  // Instead: the tool stands in the frame, which moves in the state `frame`; the joints are at `position` now.
  void begin_moving(const PerAxis<Radians>& position, const AxisState& frame) noexcept;
  // The path to execute from now on. It was planned in the frame at the displacement `planned_mm`, and it begins where
  // the tool stands in the frame. The plan must outlive the motion on it.
  void start(const CartesianPlan& plan, double planned_mm) noexcept;
  // Instead: the tool stands in the frame for this time.
  void start_dwell(Ticks duration) noexcept;
  // The frame comes to rest.
  void release() noexcept;

  // What makes a set-point impossible.
  struct Trouble {
    bool any = false;
    std::uint8_t axis = 0;  // 1..6, or 0
  };
  // Computes the set-point of the next tick. `belt`: displacement and velocity that the frame should have then. After
  // a trouble the set-point is still the one before.
  [[nodiscard]] Trouble advance(const AxisState& belt) noexcept;

  [[nodiscard]] const PerAxis<Radians>& position() const noexcept { return position_; }
  // The state of motion at the set-point, see state_after().
  [[nodiscard]] PerAxis<AxisState> state() const noexcept;
  // Of the path or the dwell.
  [[nodiscard]] Ticks elapsed() const noexcept { return elapsed_; }
  [[nodiscard]] bool path_done() const noexcept { return elapsed_ >= duration_; }
  // Displacement of the frame minus that of the belt, in mm.
  [[nodiscard]] double deviation_mm() const noexcept { return deviation_mm_; }
  [[nodiscard]] bool synchronised() const noexcept;
  // After release().
  [[nodiscard]] bool frame_at_rest() const noexcept { return released_ && frame_.at_rest(); }

 private:
  [[nodiscard]] Transform base_T_flange(const Transform& planned_T_tool, double frame_mm) const noexcept;

  const RobotModel& robot_;
  const Arm& arm_;
  const ConveyorConfig& config_;
  Transform flange_T_tool_, tool_T_flange_;
  double limit_share_;
  PerAxis<double> max_speed_rad_s_;
  const CartesianPlan* plan_ = nullptr;
  Ticks duration_{}, elapsed_{};  // of the plan, or without one of a dwell
  Transform pose_{};              // of the tool, for the frame at planned_mm_
  double planned_mm_ = 0.0;
  AxisFollower follower_{};
  AxisState frame_{};
  PhaseLaw leaving_{};  // of the frame after release()
  std::int64_t leaving_ticks_ = 0;
  bool released_ = false;
  double deviation_mm_ = 0.0;
  PerAxis<Radians> position_{}, previous_{}, before_{};
};

}  // namespace armature
