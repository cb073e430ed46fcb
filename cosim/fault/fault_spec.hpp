// [[fault]]: what goes wrong during a run. Each kind has a struct with its keys in the user's units (kinds/).
//
// FaultKind is the list of all kinds. tables/fault_kinds.hpp has an entry for each; cosim/fault makes them happen.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <variant>

#include "cosim/fault/kinds/chip_kinds.hpp"
#include "cosim/fault/kinds/line_kinds.hpp"
#include "cosim/fault/kinds/plant_kinds.hpp"

namespace armature::cosim {

// A kind that acts inside of a part, which not every run has: flops (RTL), or the memory of the cores (simulator of ARM
// instructions).
template <class Kind>
concept FaultInside = std::same_as<Kind, FlopFlip> || std::same_as<Kind, MemoryFlip>;

// A kind whose fault ends after a time.
template <class Kind>
concept FaultWithDuration = requires(const Kind& fault) {
  fault.duration_s;
};

// The members of a struct are the keys of its kind.
using FaultKind =
    std::variant<PulseLoss, SlowCore, Estop, ClockStop, StrayWrite, BlockHang, ExtraPulses, DriveAlarm, AxisBlocked,
                 EncoderStuck, EncoderCable, EncoderSwapped, EncoderChatter, EncoderNoise, EncoderMiscount, IndexSlip,
                 SwitchStuck, SwitchBounce, InterruptLost, CoreOneStuck, SlaveError, SlowSlave, RegisterFlip, BrakeSlip,
                 UartBreak, UartNoise, UartOverrun, FlopFlip, MemoryFlip, CollisionTorque>;

// What a fault waits for, from its time on.
enum class FaultWhen : std::uint8_t {
  kTime,        // nothing else
  kPasses,      // a motor passes a place
  kSpeed,       // the set-points of an axis are that fast
  kMoveBegins,  // a move of the scenario begins
};

struct FaultSpec {
  double at_s = 0;
  FaultKind kind{};
  int line = 0;  // in the scenario file
  FaultWhen when = FaultWhen::kTime;
  int when_axis = 1;           // kPasses, kSpeed: 1..6
  double when_deg = 0;         // kPasses: joint angle
  double when_deg_s = 0;       // kSpeed: in either direction
  std::int64_t when_move = 0;  // kMoveBegins: index in the scenario

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

// The axis that the fault acts on, 1..6; none: its kind has no axis.
[[nodiscard]] constexpr std::optional<int> fault_axis(const FaultKind& kind) {
  return std::visit(
      []<class Kind>(const Kind& fault) -> std::optional<int> {
        if constexpr (requires { fault.axis; }) {
          return fault.axis;
        } else {
          return std::nullopt;
        }
      },
      kind);
}

}  // namespace armature::cosim
