// The tool's pins as registers: a stand-in for axi_gpio, written from its register description.
#pragma once

#include <cstdint>
#include <stdexcept>

#include "controller/hal/register_bus.hpp"

namespace armature::test {

class FakeGpio {
 public:
  std::uint16_t outputs = 0;  // bit i is pin i + 1
  std::int64_t reads = 0, writes = 0;

  void set_input(int pin, bool level) {
    const auto bit = static_cast<std::uint16_t>(1u << (pin - 1));
    const auto levels = static_cast<std::uint16_t>(level ? inputs_ | bit : inputs_ & ~bit);
    if (levels != inputs_) isr_ |= 2u;
    inputs_ = levels;
  }
  [[nodiscard]] bool interrupts() const { return enabled_ && (isr_ & ier_) != 0; }

  std::uint32_t read32(RegAddr addr) {
    ++reads;
    switch (addr.value) {
      case 0x4120'0000:
        return outputs;
      case 0x4120'0008:
        return inputs_;
      case 0x4120'0120:
        return isr_;
      default:
        throw std::logic_error{"no such register"};
    }
  }
  void write32(RegAddr addr, std::uint32_t value) {
    ++writes;
    switch (addr.value) {
      case 0x4120'0000:
        outputs = static_cast<std::uint16_t>(value);
        return;
      case 0x4120'011C:
        enabled_ = (value >> 31) != 0;
        return;
      case 0x4120'0120:
        isr_ ^= value & 3u;
        return;
      case 0x4120'0128:
        ier_ = value & 3u;
        return;
      default:
        throw std::logic_error{"no such register"};
    }
  }

 private:
  std::uint16_t inputs_ = 0;
  std::uint32_t isr_ = 0, ier_ = 0;
  bool enabled_ = false;
};

}  // namespace armature::test
