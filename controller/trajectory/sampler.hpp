// Turns the plan that is being executed into one set-point per tick.
#pragma once

#include <optional>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/joint_move.hpp"
#include "controller/trajectory/stop_move.hpp"

namespace armature {

class Sampler {
 public:
  // Stands at `position`. The model must outlive the sampler.
  Sampler(const RobotModel& robot, const PerAxis<Radians>& position) noexcept;
  Sampler(const Sampler&) = delete;
  Sampler& operator=(const Sampler&) = delete;

  // Gives up what it does and stands at `position`.
  void hold(const PerAxis<Radians>& position) noexcept;

  // Executes `plan`, which begins where the sampler stands. Only while it stands.
  void start(const JointPlan& plan) noexcept;

  // Leaves the plan's timing and brakes along its path as hard as the joints may. Nothing while it stands or brakes.
  void stop() noexcept;

  // The set-point of the next tick; the last one again while it stands.
  [[nodiscard]] const PerAxis<Radians>& advance() noexcept;

  [[nodiscard]] bool moving() const noexcept { return moving_; }
  [[nodiscard]] const PerAxis<Radians>& position() const noexcept { return position_; }

 private:
  const RobotModel& robot_;
  PerAxis<Radians> position_;
  JointPlan plan_{};
  Ticks elapsed_{};
  std::optional<StopMove> stop_;
  bool moving_ = false;
};

}  // namespace armature
