// The sources of set-points of core 0, one for each activity. A new one is a member here, with its place in all().
#pragma once

#include <array>
#include <optional>

#include "controller/activity/activity_id.hpp"
#include "controller/activity/activity_source.hpp"
#include "controller/activity/channel.hpp"
#include "controller/activity/conveyor/conveyor_source.hpp"
#include "controller/activity/homing/homing_source.hpp"
#include "controller/activity/jog/jog_source.hpp"
#include "controller/activity/plans/plan_source.hpp"
#include "controller/activity/stream/stream_source.hpp"
#include "controller/cell/conveyor_config.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/event.hpp"
#include "controller/motion/logic_port.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

// What the conveyor needs: all null without one. They must outlive its source.
struct BeltParts {
  const ConveyorConfig* config = nullptr;
  BeltSensor* sensor = nullptr;
  BeltCorrection* correction = nullptr;  // null without a network
};

struct Sources {
  // References must outlive the object. `path_arm`: solves the poses of planned paths; `arm`: all others.
  Sources(const RobotModel& robot, const Arm& path_arm, const Arm& arm, const Transform& flange_T_tool,
          Channel& channel, EventListener& events, LogicPort& logic, const BeltParts& belt) noexcept
      : plans{robot, path_arm, channel, events},
        jog{robot, arm, flange_T_tool, events},
        stream{robot, events},
        homing{robot, logic, events} {
    if (belt.config == nullptr || belt.sensor == nullptr) return;
    conveyor.emplace(robot, arm, flange_T_tool, *belt.config, *belt.sensor, channel, events, belt.correction);
  }

  // By ActivityId; null without a conveyor.
  [[nodiscard]] std::array<ActivitySource*, kActivities> all() noexcept {
    return {&plans, &jog, &stream, &homing, conveyor ? &*conveyor : nullptr};
  }

  PlanSource plans;
  JogSource jog;
  StreamSource stream;
  HomingSource homing;
  std::optional<ConveyorSource> conveyor;
};

}  // namespace armature
