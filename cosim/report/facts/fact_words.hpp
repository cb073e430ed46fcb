// Values, expected values and texts of facts that need more than one member of RunFacts or ExpectSpec.
#pragma once

#include <optional>
#include <string>

#include "cosim/report/facts/fact_entry.hpp"

namespace armature::cosim {

// ---- values
[[nodiscard]] FactValue refused_moves(const RunFacts& facts);
[[nodiscard]] FactValue refusals(const RunFacts& facts);
[[nodiscard]] FactValue jog_ends(const RunFacts& facts);
[[nodiscard]] FactValue homing_ends(const RunFacts& facts);
[[nodiscard]] FactValue unfinished_moves(const RunFacts& facts);
[[nodiscard]] FactValue move_ticks(const RunFacts& facts);
[[nodiscard]] FactValue taken_ticks(const RunFacts& facts);
[[nodiscard]] FactValue first_profile(const RunFacts& facts);
[[nodiscard]] FactValue stopped_by(const RunFacts& facts);
[[nodiscard]] FactValue missed_stop(const RunFacts& facts);
[[nodiscard]] FactValue fault_causes(const RunFacts& facts);
[[nodiscard]] FactValue serial_sent(const RunFacts& facts);

// ---- expected values
[[nodiscard]] std::optional<FactValue> wanted_profile(const ExpectSpec& expect, std::size_t axis_count);
[[nodiscard]] std::optional<FactValue> wanted_orientation(const ExpectSpec& expect, std::size_t axis_count);
[[nodiscard]] std::optional<FactValue> wanted_outputs(const ExpectSpec& expect, std::size_t axis_count);
template <bool kAsHex>
[[nodiscard]] std::optional<FactValue> wanted_serial(const ExpectSpec& expect, std::size_t) {
  if (!expect.serial_sent || expect.serial_as_hex != kAsHex) return std::nullopt;
  return SerialText{.bytes = *expect.serial_sent, .errors = 0, .as_hex = kAsHex};
}

[[nodiscard]] FactValue program_end(const RunFacts& facts);
[[nodiscard]] FactValue program_end_line(const RunFacts& facts);

// ---- words
[[nodiscard]] std::string program_end_text(const RunFacts& facts);
[[nodiscard]] std::string refused_moves_text(const RunFacts& facts);
[[nodiscard]] std::string unfinished_moves_text(const RunFacts& facts);
[[nodiscard]] std::string first_profile_text(const RunFacts& facts);
[[nodiscard]] std::string stopped_by_text(const RunFacts& facts);
[[nodiscard]] std::string stop_ticks_text(const RunFacts& facts);
[[nodiscard]] std::string settle_text(const RunFacts& facts);
template <auto kMember>
[[nodiscard]] std::string tool_text(const RunFacts& facts) {
  return facts.*kMember ? value_text(to_value(facts.*kMember, facts.axis_count)) : "not measured";
}
template <auto kMember>
[[nodiscard]] std::string deviation_text(const RunFacts& facts) {
  return facts.*kMember ? value_text(measured<kMember>(facts)) : "no move on a line or an arc that was measured";
}
// Why no stretch can be judged. Empty if it can.
[[nodiscard]] std::string no_path(const RunFacts& facts);

// ---- where
[[nodiscard]] FactWhere last_outside(const RunFacts& facts);
template <auto kMember>
[[nodiscard]] FactWhere deviation_where(const RunFacts& facts) {
  return facts.*kMember ? at_place((facts.*kMember)->where) : FactWhere{};
}

}  // namespace armature::cosim
