// Fixture of axi_gpio with its bus and the pads of both channels, as a board with tri-state buffers has them: a driven
// pad has the level of its output, and a released pad the level that the outside world gives it.
// Offsets are written out on purpose: they are the vendor's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "tests/support/axi_stall_test.hpp"

namespace armature::test {

namespace gpio {
inline constexpr std::uint32_t kData = 0x000, kTri = 0x004, kData2 = 0x008, kTri2 = 0x00C;
inline constexpr std::uint32_t kGier = 0x11C, kIsr = 0x120, kIer = 0x128;
inline constexpr std::uint32_t kGlobalEnable = 0x8000'0000U, kChannel1 = 1, kChannel2 = 2;
inline constexpr std::uint32_t kMapBytes = 0x200;

// Registers and status bit of a channel, 0 or 1.
struct Channel {
  std::uint32_t data, tri, status;
};
inline constexpr std::array<Channel, 2> kChannels{{{kData, kTri, kChannel1}, {kData2, kTri2, kChannel2}}};
}  // namespace gpio

// Dut: Vaxi_gpio, or the same block with other parameters.
template <class Dut>
class AxiGpioFixture : public AxiStallTest<Dut> {
 protected:
  void SetUp() override { restart(0, 0); }

  // Reset with these levels outside.
  void restart(std::uint16_t channel1, std::uint16_t channel2) {
    outside_ = {channel1, channel2};
    AxiStallTest<Dut>::SetUp();
    this->axi_.step(8);
  }

  void clock() override {
    this->dut_.gpio_i = pads(0);
    this->dut_.gpio2_i = pads(1);
    this->tick();
  }

  // Levels of the pads of a channel, 0 or 1.
  [[nodiscard]] std::uint16_t pads(std::size_t channel) const {
    const std::uint32_t driven = channel == 0 ? this->dut_.gpio_o : this->dut_.gpio2_o;
    const std::uint32_t released =
        (channel == 0 ? this->dut_.gpio_t_o : this->dut_.gpio2_t_o) | (shorted_ ? 0xFFFFU : 0U);
    return static_cast<std::uint16_t>((driven & ~released) | (outside_[channel] & released));
  }

  void write(std::uint32_t offset, std::uint32_t value, unsigned strobe = 0xF) {
    AxiStallTest<Dut>::write(offset, value, strobe);
    this->axi_.step();
  }

  void enable(std::uint32_t channels) {
    write(gpio::kIer, channels);
    write(gpio::kGier, gpio::kGlobalEnable);
  }

  // The outside world changes the level of every released pad of a channel.
  void input(std::size_t channel, std::uint32_t level) {
    outside_[channel] = static_cast<std::uint16_t>(level);
    this->axi_.step(8);
  }

  std::array<std::uint16_t, 2> outside_{};
  bool shorted_ = false;  // every pad has the level outside, also where it is driven
};

}  // namespace armature::test
