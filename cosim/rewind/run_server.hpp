// The process of a ReversibleRun: it owns the run and does what it is asked.
#pragma once

#include <vector>

#include "cosim/rewind/run_messages.hpp"
#include "cosim/rewind/stop_condition.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/snapshot/message_channel.hpp"

namespace armature::cosim {

// Ends the process when the other end of the channel is closed.
[[noreturn]] void serve_run(const Scenario& scenario, const std::vector<StopCondition*>& conditions,
                            KeepTrace keep_trace, MessageChannel& channel);

}  // namespace armature::cosim
