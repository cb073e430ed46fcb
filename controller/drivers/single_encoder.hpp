// The one quadrature decoder of the paper's variant, behind the encoder switch: the registers of `Encoder`, of which
// only the first axis is there.
#pragma once

#include <cstdint>

#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class SingleEncoder {
 public:
  explicit SingleEncoder(RegisterBus& bus, RegAddr base = {regs::soc::kEncoderBase}) noexcept
      : bus_{bus}, base_{base} {}

  // True when the block is there with one axis and the register map that this driver knows.
  [[nodiscard]] bool identified() noexcept;

  // Both lines have been stable since reset; before, the position stands still and no flag tells of it.
  [[nodiscard]] bool known() noexcept;

  // At the last trigger: the counts of all encoders that have been selected, each while it was. Wraps.
  [[nodiscard]] std::int32_t position() noexcept;
  // Of the last trigger, in clock cycles since reset; 0 before the first. Wraps.
  [[nodiscard]] std::uint32_t trigger_time() noexcept;

  // Both lines have changed at once since the flag was last cleared; a change of the switch can do so too.
  [[nodiscard]] bool illegal_seen() noexcept;
  void clear_illegal_seen() noexcept;

 private:
  RegisterBus& bus_;
  RegAddr base_;
};

}  // namespace armature
