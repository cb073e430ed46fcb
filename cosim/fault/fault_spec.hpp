// [[fault]]: what goes wrong during a run. Each kind has a struct with its keys in the user's units.
//
// FaultKind is the list of all kinds. tables/fault_kinds.hpp has an entry for each; cosim/fault makes them happen.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "cosim/logic/logic_spec.hpp"

namespace armature::cosim {

// The drive of an axis does not see its next pulses. Ends by itself when they are lost.
struct PulseLoss {
  int axis = 1;            // 1..6
  std::int64_t count = 0;  // pulses, at least 1

  friend bool operator==(const PulseLoss&, const PulseLoss&) = default;
};

// From then on, core 0 needs this time to compute a tick.
struct SlowCore {
  double compute_us = 0;  // a cycle of the clock or longer

  friend bool operator==(const SlowCore&, const SlowCore&) = default;
};

// The pin estop_ni is low for this time.
struct Estop {
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const Estop&, const Estop&) = default;
};

// The clock of the logic stands still for this time.
struct ClockStop {
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const ClockStop&, const ClockStop&) = default;
};

// A program error: the processor writes this word to the bus.
struct StrayWrite {
  std::int64_t address = 0;  // 32 bits, a multiple of 4
  std::int64_t data = 0;     // 32 bits

  friend bool operator==(const StrayWrite&, const StrayWrite&) = default;
};

// From then on, the gated clock of these blocks stands still: they answer no access.
struct BlockHang {
  ClockGroup clock = ClockGroup::kIo;

  friend bool operator==(const BlockHang&, const BlockHang&) = default;
};

// A kind whose fault ends after a time.
template <class Kind>
concept FaultWithDuration = requires(const Kind& fault) {
  fault.duration_s;
};

// The members of a struct are the keys of its kind.
using FaultKind = std::variant<PulseLoss, SlowCore, Estop, ClockStop, StrayWrite, BlockHang>;

struct FaultSpec {
  double at_s = 0;
  FaultKind kind{};
  int line = 0;  // in the scenario file

  friend bool operator==(const FaultSpec&, const FaultSpec&) = default;
};

// How long the fault lasts [s]; none: its kind has no duration.
[[nodiscard]] constexpr std::optional<double> fault_duration_s(const FaultKind& kind) {
  return std::visit(
      []<class Kind>(const Kind& fault) -> std::optional<double> {
        if constexpr (FaultWithDuration<Kind>) {
          return fault.duration_s;
        } else {
          return std::nullopt;
        }
      },
      kind);
}

}  // namespace armature::cosim
