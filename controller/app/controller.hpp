// The controller of Vo 2021 section 4.2: composition of everything that runs on the two ARM cores.
//
// Core 0 runs the 50 us tick for ever; core 1 takes commands, checks and plans them and hands finished plans to core 0.
// Both mains are ordinary blocking code over RegisterBus; neither allocates, throws or prints.
#pragma once

#include <optional>

#include "controller/app/core1_loop.hpp"
#include "controller/app/host_receiver.hpp"
#include "controller/command/command.hpp"
#include "controller/command/dispatcher.hpp"
#include "controller/command/inbox.hpp"
#include "controller/command/planning_config.hpp"
#include "controller/command/tool_io.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/mailbox/controller_end.hpp"
#include "controller/mailbox/memory.hpp"
#include "controller/motion/mailbox.hpp"
#include "controller/motion/paper_logic_port.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/profile/synchronise.hpp"

namespace armature {

struct ControllerConfig {
  SyncRule sync = SyncRule::kFig9;
  bool feedback = true;                  // encoder feedback corrects the commanded pulses; never with `paper`
  std::optional<PaperEncoders> paper{};  // the logic is that of Vo 2021; none: that of this controller
  Transform flange_T_tool{};             // the tool centre point and its axes
  UserFrames base_T_user{};              // element i is FrameId{i + 1}; moves in a frame that is not set are refused
  double max_stretch = PlanningConfig{}.max_stretch;
};

class Controller {
 public:
  // References must outlive the controller. `memory` is all that the controller and its host share: commands, events
  // and telemetry go through it; the host has prepared it (mailbox/host_end.hpp) and wakes core 1 for new commands.
  Controller(const RobotModel& robot, const ControllerConfig& config, mailbox::Memory& memory) noexcept;
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  // The two mains; each is called once, on its own core, and returns only when wait_for_interrupt answers kNone.
  void core0_main(RegisterBus& bus) noexcept;
  void core1_main(RegisterBus& bus) noexcept;

 private:
  const RobotModel& robot_;
  std::optional<PaperEncoders> paper_;
  bool feedback_;
  PlanningConfig planning_;
  Arm arm_;
  mailbox::Core0Writer core0_writer_;
  mailbox::Core1Writer core1_writer_;
  Inboxes inboxes_;
  MotionMailbox mailbox_;
  HostReceiver receiver_;
  Core1Loop core1_;
  ToolIo tool_;
  Dispatcher dispatcher_;
};

}  // namespace armature
