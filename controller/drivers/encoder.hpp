// The six quadrature decoders: positions of the last trigger and their fault flags.
#pragma once

#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class Encoder {
 public:
  // Sticky event flags, axis masks with bit 0 for axis 1.
  struct Faults {
    std::uint8_t illegal = 0;  // both lines changed at once
    std::uint8_t index = 0;    // two index pulses not a whole revolution apart
    [[nodiscard]] bool any() const noexcept { return (illegal | index) != 0; }
  };

  explicit Encoder(RegisterBus& bus, RegAddr base = {regs::soc::kEncoderBase}) noexcept : bus_{bus}, base_{base} {}

  // True when the block is there with the register map that this driver knows.
  [[nodiscard]] bool identified() noexcept;

  // Counts per revolution (1 .. 2^24-1) of each encoder, and switches the index check on for all axes.
  void configure(const PerAxis<std::int32_t>& counts_per_rev) noexcept;

  // Axes that count, mask with bit 0 for axis 1. Both lines of the others have not yet been stable since reset: their
  // positions stand still and no fault flag tells of it. An axis that is known stays so.
  [[nodiscard]] std::uint8_t known() noexcept;

  // Positions at the last trigger. The low 32 bits: wraps.
  [[nodiscard]] PerAxis<std::int32_t> positions() noexcept;

  [[nodiscard]] Faults faults() noexcept;
  // Clears exactly the flags that are set in `faults`.
  void clear(const Faults& faults) noexcept;

 private:
  RegisterBus& bus_;
  RegAddr base_;
};

}  // namespace armature
