// A bit that a sweep flips: of a flop of the logic, or of the memory of the cores.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

#include "cosim/fault/fault_spec.hpp"

namespace armature::cosim {

struct Flip {
  std::string part{};                    // the row of the table: a block of the logic, or a part of the memory
  std::string name{};                    // of the flop, or a symbol of the firmware
  std::optional<std::int64_t> offset{};  // of the word behind the symbol [bytes]; none: a flop
  int bit = 0;

  friend auto operator<=>(const Flip&, const Flip&) = default;
};

// `flop_flip` or `memory_flip`.
[[nodiscard]] FaultKind fault_of(const Flip& flip);
// As key=value of the table [[fault]], without its time.
[[nodiscard]] std::string keys_of(const Flip& flip);

// The block of a flop: `u_encoder` of `g_rtl.u_encoder.u_core.u_position.position_q`, `pins` of an output of the chip.
[[nodiscard]] std::string block_of(const std::string& flop);

}  // namespace armature::cosim
