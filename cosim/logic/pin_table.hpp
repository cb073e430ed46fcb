// Table of the pins of the logic by the names of its ports: all ports except clocks, reset and bus.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "cosim/logic/pins.hpp"

namespace armature::cosim {

struct Pin {
  std::string_view name;  // of the port, as rtl/REGISTERS.md lists it
  int bits;               // 1..32; one bit per axis: axis 1 is bit 0
  std::uint32_t (*get)(const SocInputs& inputs, const SocOutputs& outputs);
  void (*set)(SocInputs& inputs, std::uint32_t value);  // null: an output. `value` fits into `bits`

  [[nodiscard]] constexpr bool is_input() const { return set != nullptr; }
  [[nodiscard]] constexpr std::uint32_t max_value() const { return ~0u >> (32 - bits); }
};

// In the order of the module's ports.
[[nodiscard]] std::span<const Pin> pins();

// Null when no pin has this name.
[[nodiscard]] const Pin* find_pin(std::string_view name);

// Make entries of the list in pin_list.hpp. kLevel: a member of SocInputs or SocOutputs.
template <auto kLevel>
constexpr Pin input_pin(std::string_view name, int bits) {
  return {name, bits, [](const SocInputs& inputs, const SocOutputs&) { return std::uint32_t{inputs.*kLevel}; },
          [](SocInputs& inputs, std::uint32_t value) {
            auto& level = inputs.*kLevel;
            level = static_cast<std::remove_reference_t<decltype(level)>>(value);
          }};
}

template <auto kLevel>
constexpr Pin output_pin(std::string_view name, int bits) {
  return {name, bits, [](const SocInputs&, const SocOutputs& outputs) { return std::uint32_t{outputs.*kLevel}; },
          nullptr};
}

}  // namespace armature::cosim
