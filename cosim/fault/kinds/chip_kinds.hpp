// Faults of the cores, their memory and the bus, and of the logic.
#pragma once

#include <cstdint>
#include <string>

#include "cosim/logic/logic_spec.hpp"

namespace armature::cosim {

// From then on, core 0 needs this time to compute a tick.
struct SlowCore {
  double compute_us = 0;  // a cycle of the clock or longer

  friend bool operator==(const SlowCore&, const SlowCore&) = default;
};

// From then on core 1 does nothing.
struct CoreOneStuck {
  friend bool operator==(const CoreOneStuck&, const CoreOneStuck&) = default;
};

// A program error: the processor writes this word to the bus.
struct StrayWrite {
  std::int64_t address = 0;  // 32 bits, a multiple of 4
  std::int64_t data = 0;     // 32 bits

  friend bool operator==(const StrayWrite&, const StrayWrite&) = default;
};

// A program error: the processor reads a register and writes it back with one bit inverted.
struct RegisterFlip {
  std::int64_t address = 0;  // 32 bits, a multiple of 4
  int bit = 0;               // 0..31

  friend bool operator==(const RegisterFlip&, const RegisterFlip&) = default;
};

// A bit of the memory of the cores flips, as by radiation.
struct MemoryFlip {
  std::string symbol{};     // of the firmware: `host_memory`
  std::int64_t offset = 0;  // of the word behind it [bytes], a multiple of 4
  int bit = 0;              // 0..31, of the word

  friend bool operator==(const MemoryFlip&, const MemoryFlip&) = default;
};

// Core 0 does not see the interrupt of axi_timer for this time.
struct InterruptLost {
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const InterruptLost&, const InterruptLost&) = default;
};

// Core 1 does not see the interrupt of axi_uart16550 for this time. It reads the receiver only when something else
// wakes it: the FIFO runs over.
struct UartOverrun {
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const UartOverrun&, const UartOverrun&) = default;
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

// The clock of the logic stands still for this time.
struct ClockStop {
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const ClockStop&, const ClockStop&) = default;
};

// From then on, the gated clock of these blocks stands still: they answer no access.
struct BlockHang {
  ClockGroup clock = ClockGroup::kIo;

  friend bool operator==(const BlockHang&, const BlockHang&) = default;
};

// A bit of a flop of the logic flips, as by radiation.
struct FlopFlip {
  std::string flop{};  // below the top module, as in waveforms: `u_axi_timer.u_core.enall_q`
  int bit = 0;         // 0..255

  friend bool operator==(const FlopFlip&, const FlopFlip&) = default;
};

}  // namespace armature::cosim
