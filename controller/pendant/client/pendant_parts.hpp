// The parts of the pendant's client, which its commands use (command_table.hpp). A part knows only those before it.
#pragma once

#include "controller/activity/arm_owner.hpp"
#include "controller/cell/planning_config.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/language/program/program_client.hpp"
#include "controller/language/store/program_store.hpp"
#include "controller/message/command.hpp"
#include "controller/message/inbox.hpp"
#include "controller/motion/arm_position.hpp"
#include "controller/pendant/client/pendant_config.hpp"
#include "controller/pendant/parts/arm_commands.hpp"
#include "controller/pendant/parts/arm_view.hpp"
#include "controller/pendant/parts/drives_delay.hpp"
#include "controller/pendant/parts/manual_motion.hpp"
#include "controller/pendant/parts/pendant_line.hpp"
#include "controller/pendant/parts/programs.hpp"
#include "controller/pendant/parts/telemetry_pages.hpp"
#include "controller/pendant/protocol/admission.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature::pendant {

struct PendantParts {
  // References must outlive the parts.
  PendantParts(const PendantConfig& config, const RobotModel& robot, const Arm& kinematics,
               const PlanningConfig& planning, const ArmPosition& arm_position, const ArmOwner& owner, Inbox& inbox,
               ProgramStore& store, ProgramClient& program) noexcept
      : profile{config.profile},
        position{arm_position},
        line{config.paper_logic},
        manual{robot, kinematics, planning},
        programs{store, program},
        arm{owner.reported(), program, manual.keys()},
        commands{inbox, arm},
        telemetry{{.profile = profile,
                   .arm = arm,
                   .coordinates = manual.coordinates(),
                   .position = position,
                   .program = program}} {}
  PendantParts(const PendantParts&) = delete;
  PendantParts& operator=(const PendantParts&) = delete;

  void stop(Stop::Kind kind) noexcept {
    manual.release();
    static_cast<void>(commands.give(Stop{.kind = kind}));
  }

  const Profile profile;
  const ArmPosition& position;
  PendantLine line;
  ManualMotion manual;
  Programs programs;
  ArmView arm;
  ArmCommands commands;
  DrivesDelay drives;
  TelemetryPages telemetry;
  bool motion_is_ours = false;   // the present motion was commanded by the pendant
  bool program_ordered = false;  // the program has got an order in this execute()
};

}  // namespace armature::pendant
