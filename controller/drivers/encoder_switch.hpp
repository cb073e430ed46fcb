// The switch of Vo 2021 in front of the one decoder. It selects which of the six encoders is counted.
#pragma once

#include <cstddef>

#include "controller/base/axes.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class EncoderSwitch {
 public:
  explicit EncoderSwitch(RegisterBus& bus, RegAddr base = {regs::soc::kEncoderSwitchBase}) noexcept
      : bus_{bus}, base_{base} {}

  // True when the block is present and has the register map that this driver supports.
  [[nodiscard]] bool identified() noexcept;

  // From now on the encoder of `axis` (0..5) is counted. The counts of the others are lost meanwhile. The change itself
  // may be counted as +1 or -1, or may raise the decoder's illegal-transition flag.
  void select(std::size_t axis) noexcept;

 private:
  RegisterBus& bus_;
  RegAddr base_;
};

}  // namespace armature
