// Why the arm was stopped: the controller knows what it detected, the simulation knows which fault was injected.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cosim/report/measure/run_facts.hpp"

namespace armature::cosim {

// The injected faults that explain a report at this place, in the order of their begins. They have begun, and act on
// the axis of the report. If there is none, those that act on no axis; then those of any axis. Faults that were over
// before the latest reset of the controller are considered last.
[[nodiscard]] std::vector<InjectedFault> causes_of(const RunFacts& facts, const RunPlace& report);

// The first thing that stopped the arm or a core.
struct FirstFault {
  enum class What : std::uint8_t {
    kReported,  // by the controller
    kBusError,  // a core got an error response and stopped
    kServoOff,  // the servo enables dropped, and nobody reported why
  };
  What what = What::kReported;
  FaultCause cause = FaultCause::kNone;  // of kReported
  RunPlace where{};
};

// None: nothing did. The drives that are off when the controller starts are no fault.
[[nodiscard]] std::optional<FirstFault> first_fault(const RunFacts& facts);

}  // namespace armature::cosim
