// A synchronised move of all joints that begins in one state of motion and ends in another: for a joint move that leads
// into a path of the tool without a stop.
#pragma once

#include "controller/base/axes.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/joint/joint_retarget.hpp"

namespace armature {

// As plan_retarget(), but it ends in the state `end`, whose positions are the target of the plan. An axis whose speed
// is above the scaled limit at the end exceeds that limit only while it accelerates to the end.
//
// The duration is the shortest one, in whole ticks, that every axis needs by itself, or a longer one for which every
// axis has a motion (AxisPassage::motion()). One above kLongestMove must not be executed. Adds the number of tried
// durations to `trials`.
[[nodiscard]] RetargetPlan plan_passage(const RobotModel& robot, const PerAxis<AxisState>& start,
                                        const PerAxis<AxisState>& end, double speed, ProfileKind kind,
                                        double accel = 1.0) noexcept;

}  // namespace armature
