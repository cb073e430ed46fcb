// The entry of a kind of fault (fault_kinds.hpp), and the keys that several kinds have.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/base/words.hpp"
#include "cosim/fault/fault_spec.hpp"
#include "cosim/scenario/keys/key.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {

inline constexpr double kMaxWord = 0xFFFF'FFFF;
inline constexpr double kMaxFlopBits = 256;  // no flop has more
inline constexpr double kMaxTorqueNm = 10'000;

template <class Kind>
struct FaultEntry {
  std::string_view name;                // the value of the key `kind`
  std::string_view text;                // what happens: a main clause in Markdown, without its full stop
  Keys<Kind> keys;                      // of scalar values; those of this kind alone
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

// The key `axis` of the kinds that act on one axis, which is one key of the table for all of them.
template <class Kind>
[[nodiscard]] Key<Kind> axis_key() {
  return key("axis", &Kind::axis, between(1, kAxes), "The fault is at this axis.").required();
}

// The details of the kinds that have these two keys.
template <FaultWithDuration Kind>
[[nodiscard]] std::string axis_and_duration(const Kind& fault) {
  return fmt::format(" of axis {}", fault.axis) + duration_details(fault);
}

// The key `line` of the kinds that act on one line of an encoder.
template <class Kind>
[[nodiscard]] Key<Kind> line_key() {
  return named_key("line", &Kind::line, "Line of the encoder.").required();
}

// The key `level` of the kinds that keep a line at it.
template <class Kind>
[[nodiscard]] Key<Kind> level_key() {
  return key("level", &Kind::level, between(0, 1), "0 is low, 1 is high.").required();
}

// The key `counts` of the kinds that move what an encoder shows, and their details.
template <class Kind>
[[nodiscard]] Key<Kind> counts_key(std::string_view text) {
  constexpr std::int64_t kMaxCounts = 1'000'000;
  return key("counts", &Kind::counts, between(-kMaxCounts, kMaxCounts, "counts"), text)
      .required()
      .checked([](Kind& fault, const KeyContext&) {
        return fault.counts != 0 ? std::string{} : std::string{"expected a magnitude of at least 1, found 0"};
      });
}
template <class Kind>
[[nodiscard]] std::string axis_and_counts(const Kind& fault) {
  return fmt::format(" of axis {}, {} counts", fault.axis, fault.counts);
}

// The key `period_us` of the kinds that toggle.
template <class Kind>
[[nodiscard]] Key<Kind> period_key() {
  return key("period_us", &Kind::period_us, between(2 * kCycleS * 1e6, 1'000'000, "us"),
             "The line inverts at the begin, and then after each half of this period.")
      .required();
}

// The keys of the kinds with glitches.
template <class Kind>
[[nodiscard]] Key<Kind> glitch_width_key() {
  return key("width_us", &Kind::width_us, between(kCycleS * 1e6, 1'000, "us"),
             "Width of a glitch, in which the level is inverted.")
      .required();
}
template <class Kind>
[[nodiscard]] Key<Kind> glitch_gap_key() {
  return key("mean_gap_us", &Kind::mean_gap_us, between(kCycleS * 1e6, 1'000'000, "us"),
             "Mean of the gaps. They are between 0 and twice the mean.")
      .required();
}

// A key of a place in bytes where a word is: a multiple of 4.
template <class Kind>
[[nodiscard]] Key<Kind> word_place_key(std::string_view name, std::int64_t Kind::*place, Rule range,
                                       std::string_view text) {
  return key(name, place, std::move(range), text).checked([place](Kind& fault, const KeyContext&) {
    return fault.*place % 4 == 0 ? std::string{} : fmt::format("expected a multiple of 4, found {}", fault.*place);
  });
}

// An address of a register.
template <class Kind>
[[nodiscard]] Key<Kind> address_key(std::string_view text) {
  return word_place_key("address", &Kind::address, between(0, kMaxWord), text).required();
}

}  // namespace armature::cosim
