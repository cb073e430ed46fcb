// axi_gpio as arm_soc has it: channel 1 drives the outputs of the tool and reads its pads, channel 2 has inputs only.
// From rtl/REGISTERS.md and rtl/axi_gpio/README.md.
//
//   edge          n          n + 1       n + 2                     n + 3
//   pin           sampled                DATA reads it, ISR        irq() 1
//   write of DATA executed   driven()
//
// Must be computed: accesses, and a few edges after a change of a pin or a write.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/regs/axi_gpio_regs.hpp"
#include "cosim/model/block.hpp"
#include "cosim/model/pin_samples.hpp"

namespace armature::cosim::model {

struct GpioInputs {
  std::uint16_t gpio1 = 0;  // pads of channel 1
  std::uint16_t gpio2 = 0;

  bool operator==(const GpioInputs&) const = default;
};

class AxiGpio {
 public:
  Answer edge(Cycles at, const Strobes& access, const GpioInputs& inputs);
  [[nodiscard]] Cycles wakes_at() const { return wakes_at_; }

  // A read without an error.
  [[nodiscard]] std::optional<std::uint32_t> peek(std::uint32_t offset) const;

  // From now on there are no edges of clk_gated_i (rtl/README.md): nothing that can be seen changes.
  void stop_gated_clock();

  // Pins of channel 1. A released output is low.
  [[nodiscard]] std::uint16_t driven() const { return driven_; }
  [[nodiscard]] bool irq() const { return irq_; }

 private:
  [[nodiscard]] Answer answer(const Strobes& access) const;
  [[nodiscard]] std::uint32_t word(std::uint32_t offset) const;
  void write(const Strobes& access);
  [[nodiscard]] std::uint32_t changed_channels(Cycles at) const;

  [[nodiscard]] std::uint16_t outputs() const { return static_cast<std::uint16_t>(data_ & ~released_); }
  [[nodiscard]] bool interrupts() const { return enabled_ && (status_ & enabled_channels_) != 0; }

  std::uint16_t data_ = regs::axi_gpio::kDataValueReset;     // DATA as written
  std::uint16_t released_ = regs::axi_gpio::kTriValueReset;  // TRI
  std::uint32_t status_ = 0, enabled_channels_ = 0;          // ISR, IER: bit i is channel i + 1
  bool enabled_ = false;                                     // GIER
  PinSamples<GpioInputs, 3> pins_;
  std::uint16_t driven_ = 0;
  bool irq_ = false;
  bool stopped_ = false;
  Cycles wakes_at_ = kNever;
};

}  // namespace armature::cosim::model
