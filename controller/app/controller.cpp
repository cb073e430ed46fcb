#include "controller/app/controller.hpp"

#include <type_traits>

#include "controller/activity/source_selector.hpp"
#include "controller/app/core0_reporter.hpp"
#include "controller/language/gcode/flow/canon_interpreter.hpp"
#include "controller/motion/count_logic_port.hpp"
#include "controller/motion/motion_loop.hpp"

namespace armature {

// A core may lose its supply, or its simulation may end, in any bus access. Its stack is then dropped and no destructor
// runs. So the objects on it must own nothing.
static_assert(std::is_trivially_destructible_v<MotionLoop> && std::is_trivially_destructible_v<CountLogicPort> &&
              std::is_trivially_destructible_v<PaperLogicPort> && std::is_trivially_destructible_v<SourceSelector> &&
              std::is_trivially_destructible_v<Core0Reporter>);

static_assert(MoveQueue::kMoves <= host_memory::kMaxWaitingMoves, "the bound of the ring of core 1's events");
static_assert(gcode::CanonInterpreter::kMaxCallsPerStep + 2 <= host_memory::kMaxProgramNotes, "the same");

Controller::Controller(const RobotModel& robot, const ControllerConfig& config,
                       host_memory::HostMemory& memory) noexcept
    : robot_{robot},
      paper_{config.paper},
      feedback_{config.feedback && !config.paper},
      referenced_{config.referenced},
      planning_{.sync = config.sync,
                .flange_T_tool = config.flange_T_tool,
                .base_T_user = config.base_T_user,
                .max_stretch = config.max_stretch,
                .conveyor = config.conveyor},
      arm_{robot},
      core0_writer_{memory},
      core1_writer_{memory},
      belt_{memory},
      receiver_{memory, inboxes_},
      core1_{channel_, core1_writer_},
      dispatcher_{robot, arm_, planning_, inboxes_, channel_, tool_, core1_},
      program_{inboxes_, dispatcher_.owner(), tool_, core1_} {
  if (config.program != nullptr) program_.set(*config.program, config.program_start);
  program_.resume_pauses_after(config.program_resumes_after);
  core1_.add(receiver_);
  core1_.add(program_);
  core1_.add(dispatcher_);
  core1_.add(Interrupts::kGpio, tool_);
  if (!config.pendant) return;
  pendant_.emplace(*config.pendant, robot, arm_, planning_, channel_.loop.position, dispatcher_.owner(),
                   inbox_of(inboxes_, Source::kPendant), program_);
  core1_.add(*pendant_);
  core1_.add(Interrupts::kUart, pendant_->line());
}

void Controller::core0_main(RegisterBus& bus) noexcept {
  Core0Reporter reporter{core0_writer_, channel_, bus};
  const ConveyorConfig* conveyor = planning_.conveyor ? &*planning_.conveyor : nullptr;
  const auto run_on = [&](LogicPort& logic) {
    if (pendant_) logic.keep_drives_off();
    SourceSelector source{robot_, arm_, planning_.flange_T_tool, channel_, reporter, logic, conveyor, &belt_};
    MotionLoop{robot_, feedback_, logic, bus, channel_.loop, source, reporter, referenced_}.run();
  };
  if (paper_) {
    PaperLogicPort logic{bus, *paper_};
    run_on(logic);
  } else {
    CountLogicPort logic{bus};
    run_on(logic);
  }
}

void Controller::core1_main(RegisterBus& bus) noexcept {
  core1_.run(bus);
}

}  // namespace armature
