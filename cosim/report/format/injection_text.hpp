// Injected faults, inputs and bus errors in words, as screen, log and summary.json show them.
// cosim/scenario/fault_text.hpp has the words for the fault itself.
#pragma once

#include <string>

#include "cosim/report/measure/injections.hpp"
#include "cosim/scenario/command_names.hpp"

namespace armature::cosim {

// `pin 3 = 1`
[[nodiscard]] std::string input_text(const InputSpec& input);

// `0.300000 s (tick 5999, cycle 15000000)`
[[nodiscard]] std::string moment_text(const RunPlace& place);

// The response of the system: `500 of 500 pulses lost, corrected by up to 500 pulses, the controller reports no fault`
[[nodiscard]] std::string answer_text(const InjectedFault& fault);
[[nodiscard]] std::string answer_text(const GivenInput& input, const CommandNames& names);

// `core 0 stopped: read of 0x43C20010 answered SLVERR`
[[nodiscard]] std::string abort_text(const BusAbortEvent& abort);

}  // namespace armature::cosim
