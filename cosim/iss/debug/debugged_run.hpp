// The process of a run that is debugged: it owns the run, stops it, and answers what is asked of it while it stands.
//
// The run stands inside the call of a CoreWatcher: an engine waits before an instruction, and with it all else. So
// simulated time stands still.
#pragma once

#include <filesystem>
#include <optional>

#include "cosim/scenario/scenario.hpp"
#include "cosim/snapshot/message_channel.hpp"

namespace armature::cosim::iss {

struct DebuggedRunOptions {
  std::optional<std::filesystem::path> wave;  // the file of `monitor wave on`; none: it is refused
  bool compare_golden = false;                // with that of the scenario
};

// Tells the first stop, before the first instruction. Ends the process at the end of the run, or when the other end of
// the channel is closed.
[[noreturn]] void serve_debugged_run(const Scenario& scenario, const DebuggedRunOptions& options,
                                     MessageChannel& channel);

}  // namespace armature::cosim::iss
