// Stopping on the path: the rest of a move is run through ever more slowly, so all joints stay on the planned path
// and start braking from the last set-points, not from measured positions.
//
// In every tick the path time advances by the least that lets no joint brake harder than its acceleration limit, taken
// on the set-points themselves: q[k+1] - q[k] >= q[k] - q[k-1] - a_max Ts^2 in its direction of motion. Such a step
// always exists: advancing as far as in the tick before needs no more than the plan's own acceleration.
#pragma once

#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/joint_move.hpp"

namespace armature {

class StopMove {
 public:
  // Begins at `path_s` of the plan, which has run at its own rate so far. Both references must outlive the stop.
  StopMove(const JointPlan& plan, const RobotModel& robot, double path_s) noexcept;

  // Advances by one tick and returns the new path time.
  double advance() noexcept;

  // The path stands still, or its end is reached.
  [[nodiscard]] bool finished() const noexcept { return finished_; }

 private:
  // The least advance of the path time that every joint allows.
  [[nodiscard]] double least_step_s() const noexcept;

  const JointPlan* plan_;
  const RobotModel* robot_;
  double path_s_;
  double step_s_;  // advance of the last tick
  bool finished_ = false;
};

}  // namespace armature
