// Says before a program runs which of its instructions will end it with an alarm.
#pragma once

#include "controller/language/job/memory/program_memory.hpp"
#include "controller/language/job/state/machine_setup.hpp"
#include "controller/language/text/diagnostics.hpp"

namespace armature::job {

// Reports a warning for each instruction that raises an alarm whenever it is executed: one that is not supported, a
// form of a move with external axes, a second group or a search, a position in the frame of the tool, a second tool of
// which the settings say nothing. Values that depend on variables are not checked.
void warn_of_alarms(const ProgramMemory& memory, const MachineSettings& settings, Diagnostics& diagnostics) noexcept;

}  // namespace armature::job
