// The pins of arm_soc by the names of its ports, all but the clock, the reset and the bus.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "cosim/fabric/fabric.hpp"

namespace armature::cosim {

struct Pin {
  std::string_view name;  // as in rtl/soc/arm_soc.sv
  int bits;               // 1..16; one bit per axis: axis 1 is bit 0
  std::uint32_t (*get)(const FabricInputs& inputs, const FabricOutputs& outputs);
  void (*set)(FabricInputs& inputs, std::uint32_t value);  // null: an output. `value` fits into `bits`

  [[nodiscard]] constexpr bool is_input() const { return set != nullptr; }
  [[nodiscard]] constexpr std::uint32_t most() const { return (1u << bits) - 1; }
};

// In the order of the module's ports.
[[nodiscard]] std::span<const Pin> pins();

// Null when there is none of that name.
[[nodiscard]] const Pin* find_pin(std::string_view name);

}  // namespace armature::cosim
