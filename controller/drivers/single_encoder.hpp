// The one quadrature decoder of the paper's variant, behind the encoder switch. It has the registers of `Encoder` for
// the first axis only.
#pragma once

#include <cstdint>

#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class SingleEncoder {
 public:
  explicit SingleEncoder(RegisterBus& bus, RegAddr base = {regs::soc::kEncoderBase}) noexcept
      : bus_{bus}, base_{base} {}

  // True when the block is present with one axis and the register map that this driver supports.
  [[nodiscard]] bool identified() noexcept;

  // True when both lines have been stable at least once since reset. Before that the position does not change, and no
  // flag reports it.
  [[nodiscard]] bool known() noexcept;

  // Position at the last trigger: the sum of the counts of all encoders, each while it was selected. Wraps.
  [[nodiscard]] std::int32_t position() noexcept;
  // Time of the last trigger, in clock cycles since reset; 0 before the first. Wraps.
  [[nodiscard]] std::uint32_t trigger_time() noexcept;

  // True when both lines changed at once since the flag was last cleared. A change of the switch can cause this too.
  [[nodiscard]] bool illegal_flag() noexcept;
  void clear_illegal_flag() noexcept;

 private:
  RegisterBus& bus_;
  RegAddr base_;
};

}  // namespace armature
