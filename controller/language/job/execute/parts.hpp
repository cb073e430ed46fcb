// The parts that execute instructions, and which of them executes which one.
#pragma once

#include <cstddef>
#include <cstdint>

#include "controller/language/job/execute/flow.hpp"
#include "controller/language/job/execute/motion.hpp"
#include "controller/language/job/execute/pins.hpp"
#include "controller/language/job/execute/planned_arm.hpp"
#include "controller/language/job/execute/positions.hpp"
#include "controller/language/job/memory/program_memory.hpp"
#include "controller/language/job/state/machine_setup.hpp"
#include "controller/language/job/state/step.hpp"
#include "controller/language/job/state/tools.hpp"
#include "controller/language/job/state/variables.hpp"

namespace armature::job {

// Each part knows those above it that it is given.
struct Parts {
  // The reference must outlive it.
  Parts(const ProgramMemory& jobs, const MachineSetup& robot) noexcept : memory{jobs}, setup{robot} {}
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  // At the first instruction of a job at or behind a line, with all as new but the user frames. kLocals: there is no
  // room for its local variables.
  [[nodiscard]] Alarm start(std::size_t job, std::uint32_t line) noexcept;
  // The record of the step. False: the step says why it is not executed.
  [[nodiscard]] bool execute(Step& step) noexcept;
  // It is executed: to the next one.
  void advance() noexcept;

  const ProgramMemory& memory;
  MachineSetup setup;
  Variables variables{};
  Flow flow{memory, variables};
  Pins pins{};
  Tools tools{setup};
  Positions positions{setup.cell, tools};
  PlannedArm arm{positions};
  Motion motion{setup.settings, tools, positions, arm};
};

}  // namespace armature::job
