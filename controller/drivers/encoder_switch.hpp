// The switch of Vo 2021 in front of the one decoder: which of the six encoders is counted.
#pragma once

#include <cstddef>

#include "controller/core/axes.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class EncoderSwitch {
 public:
  explicit EncoderSwitch(RegisterBus& bus, RegAddr base = {regs::soc::kEncoderSwitchBase}) noexcept
      : bus_{bus}, base_{base} {}

  // True when the block is there with the register map that this driver knows.
  [[nodiscard]] bool identified() noexcept;

  // From now on the encoder of `axis` (0..5) is counted. The others are lost meanwhile, and the change itself may be
  // counted as +1 or -1 or raise the decoder's flag of an illegal transition.
  void select(std::size_t axis) noexcept;

 private:
  RegisterBus& bus_;
  RegAddr base_;
};

}  // namespace armature
