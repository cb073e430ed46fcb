// Injected faults, inputs and bus errors in words, as screen, log and summary.json show them.
// cosim/scenario/fault_text.hpp has the words for the fault itself.
#pragma once

#include <string>

#include "cosim/report/measure/injections.hpp"
#include "cosim/report/measure/run_facts.hpp"
#include "cosim/scenario/command_names.hpp"

namespace armature::cosim {

// `pin 3 = 1`
[[nodiscard]] std::string input_text(const InputSpec& input);

// `0.300000 s (tick 5999, cycle 15000000)`
[[nodiscard]] std::string moment_text(const RunPlace& place);

// The response of the system: `500 of 500 pulses lost, corrected by up to 500 pulses, the controller reports no fault`
[[nodiscard]] std::string answer_text(const InjectedFault& fault);
[[nodiscard]] std::string answer_text(const GivenInput& input, const CommandNames& names);

// What stopped the arm, and the injected faults behind it: `following_error of axis 4 at tick 6120: encoder_stuck of
// axis 4, line b = 1 for 1 s since cycle 15300211`. Empty: nothing stopped it.
[[nodiscard]] std::string first_fault_text(const RunFacts& facts);
// The part behind the colon, of any report.
[[nodiscard]] std::string cause_text(const RunFacts& facts, const RunPlace& report);

// `core 0 stopped: read of 0x43C20010 answered SLVERR`
[[nodiscard]] std::string abort_text(const BusAbortEvent& abort);

}  // namespace armature::cosim
