// What the activities of core 1 share.
#pragma once

#include "controller/activity/arm_owner.hpp"
#include "controller/activity/channel.hpp"
#include "controller/activity/move_queue.hpp"
#include "controller/cell/frames.hpp"
#include "controller/cell/planning_config.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/event.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

// References must outlive the activities.
struct ActivityContext {
  const RobotModel& robot;
  const Arm& arm;
  const PlanningConfig& config;
  UserFrames& frames;  // the last one is that in which a path on the conveyor is planned
  ArmOwner& owner;
  MoveQueue& queue;
  Channel& channel;
  EventListener& events;
};

}  // namespace armature
