// [[fault]]: what goes wrong during a run. Each kind has a struct with its keys in the user's units.
//
// FaultKind is the list of all kinds. tables/fault_kinds.hpp has an entry for each; cosim/fault makes them happen.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
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

// ---- drives and mechanics

// The drive of an axis counts each of its next pulses twice. Ends by itself after these pulses.
struct ExtraPulses {
  int axis = 1;            // 1..6
  std::int64_t count = 0;  // pulses, at least 1

  friend bool operator==(const ExtraPulses&, const ExtraPulses&) = default;
};

// The drive of an axis has an internal fault for this time. Its alarm stays until the servo is off and the fault over.
struct DriveAlarm {
  int axis = 1;           // 1..6
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const DriveAlarm&, const DriveAlarm&) = default;
};

// The motor shaft of an axis cannot turn for this time: the arm has hit something.
struct AxisBlocked {
  int axis = 1;           // 1..6
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const AxisBlocked&, const AxisBlocked&) = default;
};

// ---- lines of encoders and switches, between them and the chip

enum class EncoderLine : std::uint8_t { kA, kB, kZ };
enum class AxisSwitch : std::uint8_t { kHome, kLimitPos, kLimitNeg };

// A line of an encoder keeps this level.
struct EncoderStuck {
  int axis = 1;  // 1..6
  EncoderLine line = EncoderLine::kA;
  int level = 0;
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const EncoderStuck&, const EncoderStuck&) = default;
};

// The cable of an encoder is broken: all of its lines are low.
struct EncoderCable {
  int axis = 1;           // 1..6
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const EncoderCable&, const EncoderCable&) = default;
};

// The lines A and B of an encoder are exchanged.
struct EncoderSwapped {
  int axis = 1;           // 1..6
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const EncoderSwapped&, const EncoderSwapped&) = default;
};

// A line of an encoder inverts at the begin, and after each half of the period.
struct EncoderChatter {
  int axis = 1;  // 1..6
  EncoderLine line = EncoderLine::kA;
  double period_us = 0;   // two cycles of the clock or longer
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const EncoderChatter&, const EncoderChatter&) = default;
};

// Glitches on a line of an encoder, with random gaps between them (seed of the scenario).
struct EncoderNoise {
  int axis = 1;  // 1..6
  EncoderLine line = EncoderLine::kA;
  double width_us = 0;     // of a glitch: a cycle of the clock or longer
  double mean_gap_us = 0;  // between two glitches: a cycle of the clock or longer
  double duration_s = 0;   // a cycle of the clock or longer

  friend bool operator==(const EncoderNoise&, const EncoderNoise&) = default;
};

// An encoder shows so many counts too many from then on, one after the other.
struct EncoderMiscount {
  int axis = 1;             // 1..6
  std::int64_t counts = 0;  // not 0; negative: too few

  friend bool operator==(const EncoderMiscount&, const EncoderMiscount&) = default;
};

// From then on the index of an encoder comes so many counts later in the positive direction.
struct IndexSlip {
  int axis = 1;             // 1..6
  std::int64_t counts = 0;  // not 0

  friend bool operator==(const IndexSlip&, const IndexSlip&) = default;
};

// A switch of an axis keeps this level.
struct SwitchStuck {
  int axis = 1;  // 1..6
  AxisSwitch which = AxisSwitch::kHome;
  int level = 0;
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const SwitchStuck&, const SwitchStuck&) = default;
};

// A switch of an axis inverts at the begin, and after each half of the period.
struct SwitchBounce {
  int axis = 1;  // 1..6
  AxisSwitch which = AxisSwitch::kHome;
  double period_us = 0;   // two cycles of the clock or longer
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const SwitchBounce&, const SwitchBounce&) = default;
};

// ---- processor and bus

// Core 0 does not see the interrupt of axi_timer for this time.
struct InterruptLost {
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const InterruptLost&, const InterruptLost&) = default;
};

// From then on core 1 does nothing.
struct CoreOneStuck {
  friend bool operator==(const CoreOneStuck&, const CoreOneStuck&) = default;
};

// The next accesses of the cores to this address are answered with SLVERR.
struct SlaveError {
  std::int64_t address = 0;  // 32 bits, a multiple of 4
  std::int64_t count = 1;    // accesses, at least 1

  friend bool operator==(const SlaveError&, const SlaveError&) = default;
};

// Each response of the bus comes later for this time.
struct SlowSlave {
  double delay_us = 0;    // a cycle of the clock or longer
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const SlowSlave&, const SlowSlave&) = default;
};

// A program error: the processor reads a register and writes it back with one bit inverted.
struct RegisterFlip {
  std::int64_t address = 0;  // 32 bits, a multiple of 4
  int bit = 0;               // 0..31

  friend bool operator==(const RegisterFlip&, const RegisterFlip&) = default;
};

// A bit of a flop of the logic flips, as by radiation.
struct FlopFlip {
  std::string flop{};  // below the top module, as in waveforms: `u_axi_timer.u_core.enall_q`
  int bit = 0;         // 0..255

  friend bool operator==(const FlopFlip&, const FlopFlip&) = default;
};

// The brake of an axis holds less, for this time.
struct BrakeSlip {
  int axis = 1;           // 1..6
  double share = 0;       // of its torque that is left, 0..1
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const BrakeSlip&, const BrakeSlip&) = default;
};

// ---- serial line

// The line to the controller is low for this time: a break.
struct UartBreak {
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const UartBreak&, const UartBreak&) = default;
};

// Glitches on the line to the controller, as EncoderNoise.
struct UartNoise {
  double width_us = 0;     // of a glitch: a cycle of the clock or longer
  double mean_gap_us = 0;  // between two glitches: a cycle of the clock or longer
  double duration_s = 0;   // a cycle of the clock or longer

  friend bool operator==(const UartNoise&, const UartNoise&) = default;
};

// Core 1 does not see the interrupt of axi_uart16550 for this time. It reads the receiver only when something else
// wakes it: the FIFO runs over.
struct UartOverrun {
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const UartOverrun&, const UartOverrun&) = default;
};

// A kind that needs an engine with flops.
template <class Kind>
concept FaultOfFlop = requires(const Kind& fault) {
  fault.flop;
};

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
                 UartBreak, UartNoise, UartOverrun, FlopFlip>;

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
