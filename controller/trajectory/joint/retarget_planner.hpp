// Plans a synchronised move of all joints from any state of motion, in parts that a tick of core 0 has time for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/joint/joint_retarget.hpp"
#include "controller/trajectory/state/axis_reach.hpp"

namespace armature {

class RetargetPlanner {
 public:
  // Of step().
  static constexpr int kParts = 3;

  // `robot` must outlive the planner.
  explicit RetargetPlanner(const RobotModel& robot) noexcept : robot_{robot} {}

  // As plan_retarget().
  void begin(const PerAxis<AxisState>& start, const RetargetGoal& goal) noexcept;
  // The next part: the duration, the laws, what they reach. Call kParts times.
  void step() noexcept;
  [[nodiscard]] bool done() const noexcept { return part_ == kParts; }

  // When it is done.
  [[nodiscard]] const RetargetPlan& plan() const noexcept { return plan_; }
  // axis_outside() of the plan.
  [[nodiscard]] std::optional<std::size_t> outside() const noexcept { return outside_; }

 private:
  void find_duration() noexcept;
  void find_laws() noexcept;
  [[nodiscard]] bool fill() noexcept;

  const RobotModel& robot_;
  PerAxis<AxisState> start_{};
  RetargetGoal goal_{};
  PerAxis<TimeLawLimits> limits_{};
  std::optional<PerAxis<AxisReach>> reach_{};
  RetargetPlan plan_{};
  std::optional<std::size_t> outside_{};
  int part_ = 0;
};

}  // namespace armature
