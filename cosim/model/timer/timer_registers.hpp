// The registers of one timer of axi_timer (rtl/REGISTERS.md). Both timers have the same bits.
#pragma once

#include <array>
#include <cstdint>

#include "controller/regs/axi_timer_regs.hpp"

namespace armature::cosim::model {

namespace timer_bits {
inline constexpr std::uint32_t kCapture = regs::axi_timer::kTcsr0MdtMask;
inline constexpr std::uint32_t kDown = regs::axi_timer::kTcsr0UdtMask;
inline constexpr std::uint32_t kGenerate = regs::axi_timer::kTcsr0GentMask;
inline constexpr std::uint32_t kCapturePin = regs::axi_timer::kTcsr0CaptMask;
inline constexpr std::uint32_t kReload = regs::axi_timer::kTcsr0ArhtMask;
inline constexpr std::uint32_t kLoad = regs::axi_timer::kTcsr0LoadMask;
inline constexpr std::uint32_t kIrq = regs::axi_timer::kTcsr0EnitMask;
inline constexpr std::uint32_t kRun = regs::axi_timer::kTcsr0EntMask;
inline constexpr std::uint32_t kFlag = regs::axi_timer::kTcsr0TintMask;
inline constexpr std::uint32_t kPwm = regs::axi_timer::kTcsr0PwmaMask;
inline constexpr std::uint32_t kRunAll = regs::axi_timer::kTcsr0EnallMask;
inline constexpr std::uint32_t kCascade = regs::axi_timer::kTcsr0CascMask;
}  // namespace timer_bits

struct TimerRegisters {
  std::uint32_t control = 0;  // TCSR without ENALL and CASC, which belong to both timers
  std::uint32_t start = 0;    // TLR

  [[nodiscard]] bool has(std::uint32_t bits) const { return (control & bits) == bits; }
  [[nodiscard]] bool interrupts() const { return has(timer_bits::kFlag | timer_bits::kIrq); }
  [[nodiscard]] bool captures() const { return has(timer_bits::kCapture | timer_bits::kCapturePin | timer_bits::kRun); }
  [[nodiscard]] bool asks_for_pwm() const {
    return has(timer_bits::kPwm | timer_bits::kGenerate) && (control & timer_bits::kCapture) == 0;
  }
};
using TimerRegisterPair = std::array<TimerRegisters, 2>;

}  // namespace armature::cosim::model
