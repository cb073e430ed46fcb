#include "controller/drivers/axi_gpio.hpp"

#include "controller/regs/axi_gpio_regs.hpp"

namespace armature {
namespace {

using namespace regs::axi_gpio;

static_assert(kDataValueMask == (1u << AxiGpio::kPins) - 1u && kData2ValueMask == kDataValueMask);

constexpr std::uint16_t bit_of(std::uint8_t pin) {
  return static_cast<std::uint16_t>(1u << (pin - 1u));
}

}  // namespace

void AxiGpio::drive_outputs() noexcept {
  bus_.write32(base_ + kTriOffset, 0);
}

void AxiGpio::set_outputs(std::uint16_t levels) noexcept {
  bus_.write32(base_ + kDataOffset, levels);
}

void AxiGpio::set_levels(std::uint16_t mask, std::uint16_t levels) noexcept {
  const std::uint32_t others = outputs() & ~std::uint32_t{mask};
  set_outputs(static_cast<std::uint16_t>(others | (levels & mask)));
}

void AxiGpio::set_output(std::uint8_t pin, bool level) noexcept {
  set_levels(bit_of(pin), level ? bit_of(pin) : std::uint16_t{0});
}

std::uint16_t AxiGpio::outputs() noexcept {
  return static_cast<std::uint16_t>(bus_.read32(base_ + kDataOffset) & kDataValueMask);
}

std::uint16_t AxiGpio::inputs() noexcept {
  return static_cast<std::uint16_t>(bus_.read32(base_ + kData2Offset) & kData2ValueMask);
}

bool AxiGpio::input(std::uint8_t pin) noexcept {
  return (inputs() & bit_of(pin)) != 0;
}

void AxiGpio::enable_input_interrupt() noexcept {
  bus_.write32(base_ + kIerOffset, kIerChannel2Mask);
  bus_.write32(base_ + kGierOffset, kGierEnableMask);
}

bool AxiGpio::acknowledge_inputs() noexcept {
  // Writing 1 toggles a bit, so a 1 to a clear bit would set it.
  const std::uint32_t changed = bus_.read32(base_ + kIsrOffset) & kIsrChannel2Mask;
  if (changed != 0) bus_.write32(base_ + kIsrOffset, changed);
  return changed != 0;
}

}  // namespace armature
