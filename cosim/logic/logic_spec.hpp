// The two independent choices about the programmable logic of a run, and the names of its clocks.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/base/words.hpp"

namespace armature::cosim {

// The variant of the logic.
enum class Variant : std::uint8_t {
  kCounts,  // a signed count per axis and tick, one decoder per axis
  kPaper,   // as Vo 2021 describes it: half periods instead of counts, one decoder behind a switch
};

// What computes the logic. All engines give the same results.
enum class Engine : std::uint8_t {
  kRtl,       // the verilated SystemVerilog
  kModel,     // an independent model of each block (cosim/model), computed from event to event
  kLockstep,  // both; every pin is compared after every clock edge
};
inline constexpr std::string_view kEngineHelp =
    "What computes the logic. `rtl`: the verilated SystemVerilog. `model`: an independent model of it, which is "
    "faster. "
    "`lockstep`: both, and the run fails at the first clock edge after which a pin differs. Results do not depend on "
    "it.";

// The blocks that share a gated clock: a bit of active_o. The crossbar, ik_cordic and policy_mlp, which have the bits
// after them, are not among them.
enum class ClockGroup : std::uint8_t {
  kIo,       // axi_gpio and axi_uart16550
  kMotion,   // axi_timer and pulse_train; variant paper: axi_timer, pulse_width and encoder_switch
  kEncoder,  // encoder
};

// [paper], used with Variant::kPaper only. That variant has no feedback.
struct PaperSpec {
  std::int64_t encoder_axis = 1;  // 1..6: the axis that the decoder sees
  std::optional<std::int64_t>
      switch_every_ticks;  // at least 2: the decoder is switched to the next axis after so many ticks
};

// A choice that replaces the one of the scenario if it has a value.
struct LogicChoice {
  std::optional<Variant> variant;
  std::optional<Engine> engine;
};

// `variant` and `engine` replaced one key and option `fabric`. Returns the name of the variant that a value of `fabric`
// meant, or an empty text for an unknown value.
inline constexpr std::string_view kOldLogicKey = "fabric";
[[nodiscard]] constexpr std::string_view variant_of_old_key(std::string_view value) {
  if (value == "rtl") return word_of(Variant::kCounts);
  return value == word_of(Variant::kPaper) ? word_of(Variant::kPaper) : std::string_view{};
}

}  // namespace armature::cosim
