// The controller of Vo 2021 section 4.2: composition of everything that runs on the two ARM cores.
//
// Core 0 runs the 50 us tick for ever. Core 1 accepts commands, checks and plans them, and sends finished plans to core
// 0. Both mains are ordinary blocking code over RegisterBus; neither allocates, throws or prints.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "controller/activity/channel.hpp"
#include "controller/activity/tool_io.hpp"
#include "controller/app/code_check.hpp"
#include "controller/app/core1_loop.hpp"
#include "controller/app/host_receiver.hpp"
#include "controller/cell/planning_config.hpp"
#include "controller/command/dispatcher.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/host_memory/boot_reader.hpp"
#include "controller/host_memory/controller_side.hpp"
#include "controller/host_memory/memory.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/inverse_solver.hpp"
#include "controller/language/program/program_client.hpp"
#include "controller/language/store/program_store.hpp"
#include "controller/message/inbox.hpp"
#include "controller/pendant/client/pendant_client.hpp"

namespace armature {

class Controller {
 public:
  // The memory must outlive the controller. It is all that the controller and its host share: robot, settings, program,
  // commands, events and telemetry pass through it. The host prepares it (host_memory/boot_memory.hpp) and wakes core 1
  // for new commands. If the memory is wrong, the controller tells the host and both cores sleep for ever.
  // `code`: code and constants of the firmware, which core 1 checks for changes; must outlive the controller.
  explicit Controller(host_memory::HostMemory& memory, std::span<const std::uint32_t> code = {}) noexcept;
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  // The mains of the two cores. Each is called once, on its own core. It returns only when wait_for_interrupt returns
  // kNone. `solver`: solves the inverse kinematics of that core; null: software does.
  void core0_main(RegisterBus& bus, InverseSolver* solver = nullptr) noexcept;
  void core1_main(RegisterBus& bus, InverseSolver* solver = nullptr) noexcept;

  [[nodiscard]] const ProgramClient& program() const noexcept { return program_; }
  // For orders; only while core 1 does not run.
  [[nodiscard]] ProgramClient& program() noexcept { return program_; }

 private:
  void load_program() noexcept;

  host_memory::BootReader boot_;
  PlanningConfig planning_;
  Arm core0_arm_, core1_arm_;
  host_memory::Core0Writer core0_writer_;
  host_memory::Core1Writer core1_writer_;
  host_memory::BeltReader belt_;
  Inboxes inboxes_;
  Channel channel_;
  HostReceiver receiver_;
  Core1Loop core1_;
  CodeCheck code_check_;
  ToolIo tool_;
  Dispatcher dispatcher_;
  ProgramStore store_;
  ProgramClient program_;
  std::optional<pendant::PendantClient> pendant_;
};

}  // namespace armature
