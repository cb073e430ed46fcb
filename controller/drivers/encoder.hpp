// The six quadrature decoders: positions of the last trigger and their fault flags.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class Encoder {
 public:
  // Sticky event flags, axis masks with bit 0 for axis 1.
  struct Faults {
    std::uint8_t illegal = 0;  // both lines changed at once
    std::uint8_t index = 0;    // two index pulses were not a whole number of revolutions apart, or the first one was
                               // not where configure() expects it
    [[nodiscard]] bool any() const noexcept { return (illegal | index) != 0; }
  };

  explicit Encoder(RegisterBus& bus, RegAddr base = {regs::soc::kEncoderBase}) noexcept : bus_{bus}, base_{base} {}

  // True when the block is present and has the register map that this driver supports.
  [[nodiscard]] bool identified() noexcept;

  // Sets the counts per revolution (1 .. 2^24-1) of each encoder and enables the index check of all axes. `zero_axes`:
  // mask of the axes that have an index at position 0; there the first index is checked, too.
  void configure(const PerAxis<std::int32_t>& counts_per_rev, std::uint8_t zero_axes) noexcept;

  // Mask of the axes that count, bit 0 for axis 1. On the other axes both lines have not been stable yet since reset:
  // their positions do not change, and no fault flag reports it. Once set, a bit stays set.
  [[nodiscard]] std::uint8_t known() noexcept;

  // Positions at the last trigger: the low 32 bits, which wrap.
  [[nodiscard]] PerAxis<std::int32_t> positions() noexcept;

  // Position at the last rising edge of the index of an axis, likewise; none before the first one.
  [[nodiscard]] std::optional<std::int32_t> index_position(std::size_t axis) noexcept;

  [[nodiscard]] Faults faults() noexcept;
  // Clears exactly the flags that are set in `faults`.
  void clear(const Faults& faults) noexcept;

 private:
  RegisterBus& bus_;
  RegAddr base_;
};

}  // namespace armature
