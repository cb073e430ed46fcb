#include "cosim/model/gpio/axi_gpio.hpp"

namespace armature::cosim::model {
namespace {

namespace gpio_regs = regs::axi_gpio;

// From here on every access is an error. Words below without a register read 0 and ignore writes.
constexpr std::uint32_t kGpioMapEnd = 0x200;
constexpr std::uint32_t kChannels = gpio_regs::kIsrChannel1Mask | gpio_regs::kIsrChannel2Mask;

// The first edge at which a level and the level before it are both samples of the pin: levels that are high after reset
// are no change.
constexpr Cycles kComparesFrom{4};

}  // namespace

Answer AxiGpio::edge(Cycles at, const Strobes& access, const GpioInputs& inputs) {
  if (stopped_) return {};
  const Answer result = answer(access);
  const std::uint32_t changed = changed_channels(at);
  irq_ = interrupts();
  driven_ = outputs();
  if (access.write) write(access);
  status_ |= changed;
  pins_.sample(inputs);
  const bool settled = pins_.are_equal() && irq_ == interrupts() && driven_ == outputs();
  wakes_at_ = settled ? kNever : at + Cycles{1};
  return result;
}

void AxiGpio::stop_gated_clock() {
  stopped_ = true;
  wakes_at_ = kNever;
}

// Outputs of channel 1 do not count.
std::uint32_t AxiGpio::changed_channels(Cycles at) const {
  if (at < kComparesFrom) return 0;
  const GpioInputs& now = pins_.ago(2);
  const GpioInputs& before = pins_.ago(3);
  return (((now.gpio1 ^ before.gpio1) & released_) != 0 ? gpio_regs::kIsrChannel1Mask : 0) |
         (now.gpio2 != before.gpio2 ? gpio_regs::kIsrChannel2Mask : 0);
}

Answer AxiGpio::answer(const Strobes& access) const {
  Answer result;
  result.werr = access.write && word_offset(access.waddr) >= kGpioMapEnd;
  if (!access.read) return result;
  const std::uint32_t offset = word_offset(access.raddr);
  result.rerr = offset >= kGpioMapEnd;
  result.rdata = result.rerr ? kUnmappedData : word(offset);
  return result;
}

std::optional<std::uint32_t> AxiGpio::peek(std::uint32_t offset) const {
  if (offset >= kGpioMapEnd) return std::nullopt;
  return word(offset);
}

std::uint32_t AxiGpio::word(std::uint32_t offset) const {
  switch (offset) {
    case gpio_regs::kDataOffset:
      return outputs() | (pins_.ago(2).gpio1 & released_);
    case gpio_regs::kTriOffset:
      return released_;
    case gpio_regs::kData2Offset:
      return pins_.ago(2).gpio2;
    case gpio_regs::kTri2Offset:
      return gpio_regs::kTri2ValueMask;  // inputs only
    case gpio_regs::kGierOffset:
      return enabled_ ? gpio_regs::kGierEnableMask : 0;
    case gpio_regs::kIsrOffset:
      return status_;
    case gpio_regs::kIerOffset:
      return enabled_channels_;
    default:
      return 0;
  }
}

void AxiGpio::write(const Strobes& access) {
  switch (word_offset(access.waddr)) {
    case gpio_regs::kDataOffset:
      data_ = static_cast<std::uint16_t>(merged(data_, access));
      break;
    case gpio_regs::kTriOffset:
      released_ = static_cast<std::uint16_t>(merged(released_, access));
      break;
    case gpio_regs::kGierOffset:
      enabled_ = (merged(enabled_ ? gpio_regs::kGierEnableMask : 0, access) & gpio_regs::kGierEnableMask) != 0;
      break;
    case gpio_regs::kIsrOffset:
      status_ ^= merged(0, access) & kChannels;
      break;
    case gpio_regs::kIerOffset:
      enabled_channels_ = merged(enabled_channels_, access) & kChannels;
      break;
    default:  // DATA2 and TRI2 of inputs, words without a register, errors
      break;
  }
}

}  // namespace armature::cosim::model
