// The two independent choices about the programmable logic of a run, and the names of its clocks.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace armature::cosim {

// The variant of the logic. Named by kVariantNames, in this order.
enum class Variant : std::uint8_t {
  kCounts,  // a signed count per axis and tick, one decoder per axis
  kPaper,   // as Vo 2021 describes it: half periods instead of counts, one decoder behind a switch
};
inline constexpr std::array<std::string_view, 2> kVariantNames{"counts", "paper"};

// The program that simulates the logic. Named by kEngineNames, in this order. All engines give the same results.
enum class Engine : std::uint8_t {
  kRtl,  // the verilated SystemVerilog
};
inline constexpr std::array<std::string_view, 1> kEngineNames{"rtl"};

// The blocks that share a gated clock: a bit of active_o. Named by kClockGroupNames, in this order. The crossbar, which
// has the bit after them, is not one of them.
enum class ClockGroup : std::uint8_t {
  kIo,       // axi_gpio and axi_uart16550
  kMotion,   // axi_timer and pulse_train; variant paper: axi_timer, pulse_width and encoder_switch
  kEncoder,  // encoder
};
inline constexpr std::array<std::string_view, 3> kClockGroupNames{"io", "motion", "encoder"};

[[nodiscard]] constexpr std::string_view clock_group_name(ClockGroup group) {
  return kClockGroupNames[static_cast<std::size_t>(group)];
}
[[nodiscard]] constexpr std::string_view variant_name(Variant variant) {
  return kVariantNames[static_cast<std::size_t>(variant)];
}
[[nodiscard]] constexpr std::string_view engine_name(Engine engine) {
  return kEngineNames[static_cast<std::size_t>(engine)];
}
static_assert(variant_name(Variant::kPaper) == "paper");
static_assert(engine_name(Engine::kRtl) == "rtl");

// The enumerator with this name, from a table of names in the order of the enumerators.
template <class Enum, std::size_t kCount>
[[nodiscard]] constexpr std::optional<Enum> named(const std::array<std::string_view, kCount>& names,
                                                  std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

// A choice that replaces the one of the scenario if it has a value.
struct LogicChoice {
  std::optional<Variant> variant;
  std::optional<Engine> engine;
};

// `variant` and `engine` replaced one key and option `fabric`. Returns the name of the variant that a value of `fabric`
// meant, or an empty text for an unknown value.
inline constexpr std::string_view kOldLogicKey = "fabric";
[[nodiscard]] constexpr std::string_view variant_of_old_key(std::string_view value) {
  if (value == "rtl") return variant_name(Variant::kCounts);
  return value == variant_name(Variant::kPaper) ? variant_name(Variant::kPaper) : std::string_view{};
}

}  // namespace armature::cosim
