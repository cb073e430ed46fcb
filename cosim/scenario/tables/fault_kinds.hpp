// What each kind of fault says about itself. The loader, KEYS.md, the schema, summary.json, screen and log follow.
// A kind of FaultKind without an entry does not compile. Those of lines and of the plant are in files of their own.
#pragma once

#include <fmt/format.h>

#include "controller/base/words.hpp"
#include "cosim/fault/fault_spec.hpp"
#include "cosim/scenario/tables/fault_entry.hpp"
#include "cosim/scenario/tables/line_fault_kinds.hpp"
#include "cosim/scenario/tables/plant_fault_kinds.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {

template <>
[[nodiscard]] inline const FaultEntry<PulseLoss>& fault_entry<PulseLoss>() {
  static const FaultEntry<PulseLoss> kEntry{
      .name = "pulse_loss",
      .text = "a drive does not see some pulses",
      .keys = {key("axis", &PulseLoss::axis, between(1, kAxes), "The drive of this axis loses the pulses.").required(),
               key("count", &PulseLoss::count, between(1, kMaxCount, "pulses"),
                   "The drive loses the next pulses, this many.")
                   .required()},
      .details = [](const PulseLoss& fault) { return fmt::format(" of axis {}, {} pulses", fault.axis, fault.count); },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<SlowCore>& fault_entry<SlowCore>() {
  static const FaultEntry<SlowCore> kEntry{
      .name = "slow_core",
      .text = "core 0 computes longer from then on",
      .keys = {key("compute_us", &SlowCore::compute_us, between(kCycleS * 1e6, 1'000'000, "us"),
                   "Core 0 computes each tick in this time.")
                   .required()},
      .details = [](const SlowCore& fault) { return fmt::format(", {} us a tick", number_text(fault.compute_us)); },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<Estop>& fault_entry<Estop>() {
  static const FaultEntry<Estop> kEntry{
      .name = "estop",
      .text = "somebody presses the emergency stop",
      .keys = {duration_key<Estop>()},
      .details = duration_details<Estop>,
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<ClockStop>& fault_entry<ClockStop>() {
  static const FaultEntry<ClockStop> kEntry{
      .name = "clock_stop",
      .text = "the clock of the logic stands still, and the levels of its outputs stay",
      .keys = {duration_key<ClockStop>()},
      .details = duration_details<ClockStop>,
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<StrayWrite>& fault_entry<StrayWrite>() {
  static const FaultEntry<StrayWrite> kEntry{
      .name = "stray_write",
      .text = "a program error of the processor writes a word to a register",
      .keys = {address_key<StrayWrite>("Address of the register on the bus, a multiple of 4."),
               key("data", &StrayWrite::data, between(0, kMaxWord), "The word.").required()},
      .details =
          [](const StrayWrite& fault) { return fmt::format(" of 0x{:X} to 0x{:08X}", fault.data, fault.address); },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<BlockHang>& fault_entry<BlockHang>() {
  static const FaultEntry<BlockHang> kEntry{
      .name = "block_hang",
      .text =
          "the clock of some blocks stands still to the end of the run. The bus answers SLVERR in their place, and a "
          "core that gets an error response from then on stops",
      .keys = {named_key(
                   "clock", &BlockHang::clock,
                   "The blocks with this clock hang. `io`: axi_gpio and axi_uart16550. `motion`: axi_timer and "
                   "pulse_train, whose triggers and watchdog then stand still, so that only `drop_out_us` removes "
                   "the servo power. `encoder`: encoder.")
                   .required()},
      .details = [](const BlockHang& fault) { return fmt::format(" of clock {}", word_of(fault.clock)); },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<InterruptLost>& fault_entry<InterruptLost>() {
  static const FaultEntry<InterruptLost> kEntry{
      .name = "interrupt_lost",
      .text = "core 0 does not see the interrupt of axi_timer. An interrupt of that time is late: it comes at the end",
      .keys = {duration_key<InterruptLost>()},
      .details = duration_details<InterruptLost>,
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<UartOverrun>& fault_entry<UartOverrun>() {
  static const FaultEntry<UartOverrun> kEntry{
      .name = "uart_overrun",
      .text =
          "core 1 does not see the interrupt of axi_uart16550. It reads the receiver only when something else wakes "
          "it, so the FIFO of 16 characters runs over",
      .keys = {duration_key<UartOverrun>()},
      .details = duration_details<UartOverrun>,
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<CoreOneStuck>& fault_entry<CoreOneStuck>() {
  static const FaultEntry<CoreOneStuck> kEntry{
      .name = "core1_stuck",
      .text = "core 1 does nothing from then on: no planning, no commands, no tool",
      .keys = {},
      .details = [](const CoreOneStuck&) { return std::string{}; },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<SlaveError>& fault_entry<SlaveError>() {
  static const FaultEntry<SlaveError> kEntry{
      .name = "slave_error",
      .text = "the bus answers SLVERR to some accesses, and the core that gets it stops",
      .keys = {address_key<SlaveError>("The accesses to this register, a multiple of 4."),
               key("count", &SlaveError::count, between(1, kMaxCount, "accesses"),
                   "The next accesses to the address, this many.")
                   .required()},
      .details =
          [](const SlaveError& fault) { return fmt::format(" of 0x{:08X}, {} accesses", fault.address, fault.count); },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<SlowSlave>& fault_entry<SlowSlave>() {
  static const FaultEntry<SlowSlave> kEntry{
      .name = "slow_slave",
      .text = "each response of the bus comes later",
      .keys = {key("delay_us", &SlowSlave::delay_us, between(kCycleS * 1e6, 20, "us"),
                   "Each response comes later by this time.")
                   .required(),
               duration_key<SlowSlave>()},
      .details =
          [](const SlowSlave& fault) {
            return fmt::format(" by {} us", number_text(fault.delay_us)) + duration_details(fault);
          },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<RegisterFlip>& fault_entry<RegisterFlip>() {
  static const FaultEntry<RegisterFlip> kEntry{
      .name = "register_flip",
      .text = "a bit of a register flips: the processor reads the register, and writes it back with the bit inverted",
      .keys = {address_key<RegisterFlip>("Address of the register on the bus, a multiple of 4, as of `stray_write`."),
               key("bit", &RegisterFlip::bit, between(0, 31), "Number of the bit.").required()},
      .details =
          [](const RegisterFlip& fault) { return fmt::format(" of bit {} at 0x{:08X}", fault.bit, fault.address); },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<MemoryFlip>& fault_entry<MemoryFlip>() {
  static const FaultEntry<MemoryFlip> kEntry{
      .name = "memory_flip",
      .text = "a bit of the memory of the cores flips",
      .keys = {key("symbol", &MemoryFlip::symbol, anything(),
                   "Global symbol of the firmware (`controller.elf`), such as `armature_charge`, `page_table`, or "
                   "`host_memory`, the memory that the controller shares with its host.")
                   .required()
                   .needs(Needs::kMemory),
               word_place_key("offset", &MemoryFlip::offset, between(-kMaxWord, kMaxWord, "bytes"),
                              "Place of the word behind the symbol, a multiple of 4."),
               key("bit", &MemoryFlip::bit, between(0, 31), "Number of the bit of the word.").required()},
      .details =
          [](const MemoryFlip& fault) {
            return fmt::format(" of bit {} at {}+{}", fault.bit, fault.symbol, fault.offset);
          },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<FlopFlip>& fault_entry<FlopFlip>() {
  static const FaultEntry<FlopFlip> kEntry{
      .name = "flop_flip",
      .text = "a bit of a flop of the logic flips between two clock edges",
      .keys = {key("flop", &FlopFlip::flop, anything(),
                   "Name of the flop below the top module, as in a waveform: `u_axi_timer.u_core.enall_q`. "
                   "`armature flips` lists them.")
                   .required()
                   .needs(Needs::kFlops),
               key("bit", &FlopFlip::bit, between(0, kMaxFlopBits - 1), "Number of the bit of the flop.").required()},
      .details = [](const FlopFlip& fault) { return fmt::format(" of bit {} of {}", fault.bit, fault.flop); },
  };
  return kEntry;
}

}  // namespace armature::cosim
