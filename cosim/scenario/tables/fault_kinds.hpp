// What each kind of fault says about itself. The loader, KEYS.md, the schema, summary.json, screen and log follow.
// A kind of FaultKind without an entry does not compile.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "controller/base/words.hpp"
#include "cosim/fault/fault_spec.hpp"
#include "cosim/scenario/keys/key.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {

template <class Kind>
struct FaultEntry {
  std::string_view name;                // the value of the key `kind`
  std::string_view text;                // what happens: a main clause in Markdown, without its full stop
  std::vector<Key<Kind>> keys;          // of scalar values; those of this kind alone
  std::string (*details)(const Kind&);  // what follows the name on screen and in the log: ` of axis 3, 500 pulses`
};

template <class Kind>
[[nodiscard]] const FaultEntry<Kind>& fault_entry() = delete;

// The key `duration_s`, which is one key of the table for all kinds that have it, and its details.
template <FaultWithDuration Kind>
[[nodiscard]] Key<Kind> duration_key() {
  return key("duration_s", &Kind::duration_s, between(kCycleS, kMaxDurationS, "s"),
             "The fault lasts for this time, at least one cycle of the clock.")
      .required();
}
template <FaultWithDuration Kind>
[[nodiscard]] std::string duration_details(const Kind& fault) {
  return fmt::format(" for {} s", number_text(fault.duration_s));
}

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
  constexpr double kMaxWord = 0xFFFF'FFFF;
  static const FaultEntry<StrayWrite> kEntry{
      .name = "stray_write",
      .text = "a program error of the processor writes a word to a register",
      .keys = {key("address", &StrayWrite::address, between(0, kMaxWord),
                   "Address of the register on the bus, a multiple of 4.")
                   .required()
                   .checked([](StrayWrite& fault, const KeyContext&) {
                     return fault.address % 4 == 0 ? std::string{}
                                                   : fmt::format("expected a multiple of 4, found {}", fault.address);
                   }),
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

}  // namespace armature::cosim
