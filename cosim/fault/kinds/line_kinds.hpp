// Faults of lines between the chip and encoders, switches and the serial line, and of other pins.
#pragma once

#include <cstdint>

namespace armature::cosim {

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

// The pin estop_ni is low for this time.
struct Estop {
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const Estop&, const Estop&) = default;
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

}  // namespace armature::cosim
