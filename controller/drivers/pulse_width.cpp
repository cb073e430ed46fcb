#include "controller/drivers/pulse_width.hpp"

#include "controller/regs/pulse_width_regs.hpp"

namespace armature {
namespace {

using namespace regs::pulse_width;
using regs::extract;
using regs::extract_axes;
using regs::extract_signed;
using regs::insert;
using regs::insert_signed;

static_assert(kWidthCount == kAxes && kEmittedCount == kAxes && kIdAxesReset == kAxes);

}  // namespace

bool PulseWidth::identified() noexcept {
  return bus_.read32(base_ + kIdOffset) == kIdWord;
}

void PulseWidth::set_servo(std::uint8_t servo_on) noexcept {
  bus_.write32(base_ + kCtrlOffset, insert(0, kCtrlServoOn, servo_on));
}

void PulseWidth::set_widths(const PerAxis<Cycles>& widths) noexcept {
  for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
    const auto width = static_cast<std::int32_t>(widths[axis].value());
    bus_.write32(base_ + (kWidthOffset + axis * kWidthStride), insert_signed(0, kWidthValue, width));
  }
}

PulseWidth::Status PulseWidth::status() noexcept {
  const std::uint32_t word = bus_.read32(base_ + kStatusOffset);
  return {.estop = (word & kStatusEstopMask) != 0,
          .estop_pin = (word & kStatusEstopPinMask) != 0,
          .armed = extract_axes(word, kStatusArmed)};
}

void PulseWidth::clear_estop_flag() noexcept {
  bus_.write32(base_ + kFaultOffset, kFaultEstopMask);
}

std::uint32_t PulseWidth::time() noexcept {
  return bus_.read32(base_ + kTimeOffset);
}

PerAxis<std::int32_t> PulseWidth::emitted() noexcept {
  PerAxis<std::int32_t> pulses;
  for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
    pulses[axis] = extract_signed(bus_.read32(base_ + (kEmittedOffset + axis * kEmittedStride)), kEmittedValue);
  }
  return pulses;
}

PulseWidth::Switches PulseWidth::switches() noexcept {
  const std::uint32_t word = bus_.read32(base_ + kSwitchesOffset);
  return {.home = extract_axes(word, kSwitchesHome),
          .limit_pos = extract_axes(word, kSwitchesLimitPos),
          .limit_neg = extract_axes(word, kSwitchesLimitNeg)};
}

PulseWidth::Drives PulseWidth::drives() noexcept {
  const std::uint32_t word = bus_.read32(base_ + kDrivesOffset);
  return {.alarm = extract_axes(word, kDrivesAlarm),
          .in_position = extract_axes(word, kDrivesInPosition),
          .servo_on = extract_axes(word, kDrivesServoOn)};
}

void PulseWidth::emergency_stop() noexcept {
  bus_.write32(base_ + kEstopOffset, kEstopStopMask);
}

void PulseWidth::clear_stop() noexcept {
  bus_.write32(base_ + kEstopOffset, kEstopClearEstopMask);
}

}  // namespace armature
