// The kinds of fault of the lines of encoders and switches, and of the serial line.
#pragma once

#include <fmt/format.h>

#include <string>

#include "controller/base/words.hpp"
#include "cosim/fault/fault_spec.hpp"
#include "cosim/scenario/tables/fault_entry.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {

template <>
[[nodiscard]] inline const FaultEntry<EncoderStuck>& fault_entry<EncoderStuck>() {
  static const FaultEntry<EncoderStuck> kEntry{
      .name = "encoder_stuck",
      .text = "a line of an encoder keeps its level",
      .keys = {axis_key<EncoderStuck>(), line_key<EncoderStuck>(), level_key<EncoderStuck>(),
               duration_key<EncoderStuck>()},
      .details =
          [](const EncoderStuck& fault) {
            return fmt::format(" of axis {}, line {} = {}", fault.axis, word_of(fault.line), fault.level) +
                   duration_details(fault);
          },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<EncoderCable>& fault_entry<EncoderCable>() {
  static const FaultEntry<EncoderCable> kEntry{
      .name = "encoder_cable",
      .text = "the cable of an encoder is broken: its lines are low",
      .keys = {axis_key<EncoderCable>(), duration_key<EncoderCable>()},
      .details = axis_and_duration<EncoderCable>,
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<EncoderSwapped>& fault_entry<EncoderSwapped>() {
  static const FaultEntry<EncoderSwapped> kEntry{
      .name = "encoder_swapped",
      .text = "the lines A and B of an encoder are exchanged",
      .keys = {axis_key<EncoderSwapped>(), duration_key<EncoderSwapped>()},
      .details = axis_and_duration<EncoderSwapped>,
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<EncoderChatter>& fault_entry<EncoderChatter>() {
  static const FaultEntry<EncoderChatter> kEntry{
      .name = "encoder_chatter",
      .text = "a line of an encoder inverts again and again",
      .keys = {axis_key<EncoderChatter>(), line_key<EncoderChatter>(), period_key<EncoderChatter>(),
               duration_key<EncoderChatter>()},
      .details =
          [](const EncoderChatter& fault) {
            return fmt::format(" of axis {}, line {}, {} us", fault.axis, word_of(fault.line),
                               number_text(fault.period_us)) +
                   duration_details(fault);
          },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<EncoderNoise>& fault_entry<EncoderNoise>() {
  static const FaultEntry<EncoderNoise> kEntry{
      .name = "encoder_noise",
      .text = "a line of an encoder has glitches, with random gaps between them from the seed of the scenario",
      .keys = {axis_key<EncoderNoise>(), line_key<EncoderNoise>(), glitch_width_key<EncoderNoise>(),
               glitch_gap_key<EncoderNoise>(), duration_key<EncoderNoise>()},
      .details =
          [](const EncoderNoise& fault) {
            return fmt::format(" of axis {}, line {}, {} us every {} us", fault.axis, word_of(fault.line),
                               number_text(fault.width_us), number_text(fault.mean_gap_us)) +
                   duration_details(fault);
          },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<EncoderMiscount>& fault_entry<EncoderMiscount>() {
  static const FaultEntry<EncoderMiscount> kEntry{
      .name = "encoder_miscount",
      .text = "an encoder shows counts that its shaft does not make, one each 2 us",
      .keys = {axis_key<EncoderMiscount>(), counts_key<EncoderMiscount>("So many counts more, or fewer if negative.")},
      .details = axis_and_counts<EncoderMiscount>,
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<IndexSlip>& fault_entry<IndexSlip>() {
  static const FaultEntry<IndexSlip> kEntry{
      .name = "index_slip",
      .text = "the index of an encoder comes at another place from then on",
      .keys = {axis_key<IndexSlip>(),
               counts_key<IndexSlip>(
                   "It comes so many counts later in the positive direction, or earlier if negative.")},
      .details = axis_and_counts<IndexSlip>,
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<SwitchStuck>& fault_entry<SwitchStuck>() {
  static const FaultEntry<SwitchStuck> kEntry{
      .name = "switch_stuck",
      .text = "a switch keeps its level",
      .keys = {axis_key<SwitchStuck>(), named_key("switch", &SwitchStuck::which, "The switch.").required(),
               level_key<SwitchStuck>(), duration_key<SwitchStuck>()},
      .details =
          [](const SwitchStuck& fault) {
            return fmt::format(" of axis {}, {} = {}", fault.axis, word_of(fault.which), fault.level) +
                   duration_details(fault);
          },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<SwitchBounce>& fault_entry<SwitchBounce>() {
  static const FaultEntry<SwitchBounce> kEntry{
      .name = "switch_bounce",
      .text = "a switch inverts again and again",
      .keys = {axis_key<SwitchBounce>(), named_key("switch", &SwitchBounce::which, "The switch.").required(),
               period_key<SwitchBounce>(), duration_key<SwitchBounce>()},
      .details =
          [](const SwitchBounce& fault) {
            return fmt::format(" of axis {}, {}, {} us", fault.axis, word_of(fault.which),
                               number_text(fault.period_us)) +
                   duration_details(fault);
          },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<UartBreak>& fault_entry<UartBreak>() {
  static const FaultEntry<UartBreak> kEntry{
      .name = "uart_break",
      .text = "the serial line to the controller is low",
      .keys = {duration_key<UartBreak>()},
      .details = duration_details<UartBreak>,
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<UartNoise>& fault_entry<UartNoise>() {
  static const FaultEntry<UartNoise> kEntry{
      .name = "uart_noise",
      .text = "the serial line to the controller has glitches, as `encoder_noise`",
      .keys = {glitch_width_key<UartNoise>(), glitch_gap_key<UartNoise>(), duration_key<UartNoise>()},
      .details =
          [](const UartNoise& fault) {
            return fmt::format(", {} us every {} us", number_text(fault.width_us), number_text(fault.mean_gap_us)) +
                   duration_details(fault);
          },
  };
  return kEntry;
}

}  // namespace armature::cosim
