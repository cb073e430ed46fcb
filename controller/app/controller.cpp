#include "controller/app/controller.hpp"

#include <type_traits>

#include "controller/activity/conveyor/belt_correction.hpp"
#include "controller/activity/source_selector.hpp"
#include "controller/app/core0_reporter.hpp"
#include "controller/app/inverse_console.hpp"
#include "controller/language/gcode/flow/canon_interpreter.hpp"
#include "controller/motion/cordic/cordic_solver.hpp"
#include "controller/motion/count_logic_port.hpp"
#include "controller/motion/motion_loop.hpp"
#include "controller/motion/paper_logic_port.hpp"

namespace armature {

// A core may lose its supply, or its simulation may end, in any bus access. Its stack is then dropped and no destructor
// runs. So the objects on it must own nothing.
static_assert(std::is_trivially_destructible_v<MotionLoop> && std::is_trivially_destructible_v<CountLogicPort> &&
              std::is_trivially_destructible_v<PaperLogicPort> && std::is_trivially_destructible_v<SourceSelector> &&
              std::is_trivially_destructible_v<Core0Reporter> && std::is_trivially_destructible_v<CordicSolver> &&
              std::is_trivially_destructible_v<InverseConsole> && std::is_trivially_destructible_v<BeltCorrection>);

static_assert(MoveQueue::kMoves <= host_memory::kMaxWaitingMoves, "the bound of the ring of core 1's events");
static_assert(gcode::CanonInterpreter::kMaxCallsPerStep + 2 <= host_memory::kMaxProgramNotes, "the same");

namespace {

void sleep_for_ever(RegisterBus& bus) noexcept {
  while (bus.wait_for_interrupt(Interrupts::kNone) != Interrupts::kNone) {
  }
}

}  // namespace

Controller::Controller(host_memory::HostMemory& memory, std::span<const std::uint32_t> code) noexcept
    : boot_{memory},
      planning_{.sync = boot_.config().sync,
                .flange_T_tool = boot_.config().flange_T_tool,
                .base_T_user = boot_.config().base_T_user,
                .max_stretch = boot_.config().max_stretch,
                .conveyor = boot_.config().conveyor},
      core0_arm_{boot_.robot()},
      core1_arm_{boot_.robot()},
      core0_writer_{memory},
      core1_writer_{memory},
      belt_{memory},
      receiver_{memory, inboxes_},
      core1_{channel_, core1_writer_},
      code_check_{code, channel_.loop},
      dispatcher_{boot_.robot(), core1_arm_, planning_, inboxes_, channel_, tool_, core1_},
      store_{{.robot = boot_.robot(),
              .arm = core1_arm_,
              .flange_T_tool = planning_.flange_T_tool,
              .base_T_user = planning_.base_T_user},
             boot_.config().job,
             boot_.config().gcode},
      program_{inboxes_, dispatcher_.owner(), tool_, core1_} {
  load_program();
  core1_.add(receiver_);
  core1_.add(program_);
  core1_.add(dispatcher_);
  core1_.add(code_check_);
  core1_.add(Interrupts::kGpio, tool_);
  if (!boot_.config().pendant) return;
  pendant_.emplace(*boot_.config().pendant, boot_.robot(), core1_arm_, planning_, channel_.loop.position,
                   dispatcher_.owner(), inbox_of(inboxes_, Source::kPendant), store_, program_);
  core1_.add(*pendant_);
  core1_.add(Interrupts::kUart, pendant_->line());
}

void Controller::load_program() noexcept {
  if (boot_.files().language == ProgramLanguage::kNone) return;
  if (store_.load_first(boot_.files(), boot_.names(), boot_.texts()) != ProgramStore::Loaded::kYes) {
    boot_.refuse_program(store_.error());
    return;
  }
  program_.set(*store_.program(), boot_.config().program_start);
  program_.resume_pauses_after(boot_.config().program_resumes_after);
}

void Controller::core0_main(RegisterBus& bus, InverseSolver* solver) noexcept {
  if (!boot_.good() || boot_.config().inverse) return sleep_for_ever(bus);
  const RobotModel& robot = boot_.robot();
  const ControllerConfig& config = boot_.config();
  core0_arm_.solve_with(solver);
  // Velocities of jogs and of a belt are differences of joint angles, for which the block has too few digits.
  Arm path_arm = core0_arm_;
  std::optional<CordicSolver> cordic;
  if (config.cordic && path_arm.known()) {
    cordic.emplace(bus, robot);
    cordic->start();
    path_arm.solve_with(&*cordic);
  }
  InverseCheck* check = cordic ? &cordic->check() : nullptr;
  Core0Reporter reporter{core0_writer_, channel_, bus};
  BeltParts belt{.config = planning_.conveyor ? &*planning_.conveyor : nullptr, .sensor = &belt_};
  std::optional<BeltCorrection> correction;
  if (belt.config != nullptr && belt.config->policy) belt.correction = &correction.emplace(bus, *belt.config->policy);
  const auto run_on = [&](LogicPort& logic) {
    if (pendant_) logic.keep_drives_off();
    if (!config.referenced) logic.start_anywhere();
    SourceSelector source{robot, path_arm, core0_arm_, planning_.flange_T_tool, channel_, reporter, logic, belt};
    const bool feedback = config.feedback && !config.paper;
    MotionLoop{robot, feedback, logic, bus, channel_.loop, source, reporter, config.referenced, check}.run();
  };
  if (config.paper) {
    PaperLogicPort logic{bus, *config.paper};
    run_on(logic);
  } else {
    CountLogicPort logic{bus};
    run_on(logic);
  }
}

void Controller::core1_main(RegisterBus& bus, InverseSolver* solver) noexcept {
  if (!boot_.good()) return sleep_for_ever(bus);
  core1_arm_.solve_with(solver);
  if (const auto& task = boot_.config().inverse) {
    InverseConsole{core1_arm_, boot_.robot().axis_count, *task, bus}.run();
    return sleep_for_ever(bus);
  }
  core1_.run(bus);
}

}  // namespace armature
