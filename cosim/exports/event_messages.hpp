// What happened in a run as messages: states, events, lines of the program.
#pragma once

#include <vector>

#include "cosim/exports/timed_message.hpp"
#include "cosim/recording/recorded_program.hpp"
#include "cosim/recording/run_record.hpp"

namespace armature::cosim {

// In the order of time. `programs`: the texts of the program, for the messages of its lines.
[[nodiscard]] std::vector<TimedMessage> event_messages(const RunRecord& run,
                                                       const std::vector<RecordedProgram>& programs);

}  // namespace armature::cosim
