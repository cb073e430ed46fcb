// The activities of core 1. A new one is a member here, with its place in all(), and its source in sources.hpp.
#pragma once

#include <tuple>

#include "controller/activity/arm_owner.hpp"
#include "controller/activity/channel.hpp"
#include "controller/activity/conveyor/conveyor_activity.hpp"
#include "controller/activity/homing/homing_activity.hpp"
#include "controller/activity/jog/jog_activity.hpp"
#include "controller/activity/move_queue.hpp"
#include "controller/activity/plans/plan_activity.hpp"
#include "controller/activity/stream/stream_activity.hpp"
#include "controller/cell/frames.hpp"
#include "controller/cell/planning_config.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/event.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

struct Activities {
  // References must outlive the object. The last one of `frames` is that in which a path on the conveyor is planned.
  Activities(const RobotModel& robot, const Arm& arm, const PlanningConfig& config, UserFrames& frames, ArmOwner& owner,
             MoveQueue& queue, Channel& channel, EventListener& events) noexcept
      : plans{robot, arm, config, frames, owner, queue, channel, events},
        conveyor{robot, arm, config, frames, owner, queue, plans, channel, events},
        jog{robot, frames, owner, channel},
        homing{robot, owner},
        stream{robot, arm, config, owner, channel} {}

  [[nodiscard]] auto all() noexcept { return std::tie(plans, conveyor, jog, homing, stream); }

  PlanActivity plans;
  ConveyorActivity conveyor;
  JogActivity jog;
  HomingActivity homing;
  StreamActivity stream;
};

}  // namespace armature
