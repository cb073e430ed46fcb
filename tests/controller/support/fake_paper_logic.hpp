// The logic of Vo 2021 as the controller's registers show it, with drives that follow at once: a register-level
// stand-in written from the register descriptions, to run a PaperLogicPort without RTL.
//
// It is core 0's RegisterBus. Each access takes some cycles; an encoder moves by the pulses of a tick when that ends.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/hal/register_bus.hpp"

namespace armature::test {

class FakePaperLogic final : public RegisterBus {
 public:
  static constexpr std::int64_t kAccessCycles = 18;
  static constexpr std::int64_t kTick = 2'500;
  // What the drives ask around a change of direction; broken rules are test failures.
  static constexpr std::int64_t kDirTime = 25;

  // World.
  std::uint32_t pulse_width_id = 0x5057'0106, switch_id = 0x5357'0106, decoder_id = 0x454E'0101;
  std::uint32_t known = 1;
  std::uint32_t illegal = 0;
  bool estop_pin = false;
  std::int32_t switch_artefact = 1;  // what a turn of the switch is decoded as

  PerAxis<std::int64_t> emitted{};  // pulses and counts, up to the last trigger
  std::int64_t triggers = 0;
  std::uint32_t servo_on = 0;

  [[nodiscard]] std::int64_t width(std::size_t axis) const { return widths_[axis]; }
  [[nodiscard]] std::int64_t active_count(std::size_t axis) const { return count(active_[axis]); }
  [[nodiscard]] std::size_t selected() const { return selected_; }
  [[nodiscard]] std::int64_t cycles_to_trigger() const { return next_trigger_ - now_; }

  void stop() {
    estop_ = true;
    active_ = {};
    armed_ = 0;
  }
  void pass(std::int64_t cycles) {
    now_ += cycles;
    while (next_trigger_ > 0 && now_ >= next_trigger_) trigger();
  }

  std::uint32_t read32(RegAddr addr) noexcept override {
    pass(kAccessCycles);
    const std::uint32_t offset = addr.value & 0xFFFF;
    switch (addr.value & 0xFFFF'0000) {
      case 0x43C1'0000:
        if (offset >= 0x60 && offset < 0x78) return static_cast<std::uint32_t>(snapshot_[(offset - 0x60) / 4]);
        if (offset == 0x00) return pulse_width_id;
        if (offset == 0x08) return (estop_ ? 1u : 0u) | (estop_pin ? 4u : 0u) | (armed_ << 8);
        if (offset == 0x10) return estop_ ? 1 : 0;
        if (offset == 0x2C) return static_cast<std::uint32_t>(now_);
        return 0;
      case 0x43C2'0000:
        if (offset == 0x00) return decoder_id;
        if (offset == 0x10) return illegal;
        if (offset == 0x14) return static_cast<std::uint32_t>(trigger_time_);
        if (offset == 0x1C) return known;
        if (offset == 0x20) return static_cast<std::uint32_t>(position_snapshot_);
        break;
      case 0x43C3'0000:
        if (offset == 0x00) return switch_id;
        break;
      default:
        break;
    }
    ADD_FAILURE() << "read of 0x" << std::hex << addr.value;
    return 0xBADA'CCE5;
  }

  void write32(RegAddr addr, std::uint32_t value) noexcept override {
    pass(kAccessCycles);
    const std::uint32_t offset = addr.value & 0xFFFF;
    switch (addr.value & 0xFFFF'0000) {
      case 0x4280'0000:
        if (offset == 0x00 && (value & 0x80) != 0 && next_trigger_ == 0) next_trigger_ = now_ + kTick;
        return;
      case 0x43C1'0000:
        if (offset >= 0x40 && offset < 0x58) {
          widths_[(offset - 0x40) / 4] = static_cast<std::int32_t>(value);
          if (!estop_) armed_ |= 1u << (offset - 0x40) / 4;
        }
        if (offset == 0x04) servo_on = value;
        if (offset == 0x0C && (value & 2) != 0 && !estop_pin) estop_ = false;
        return;
      case 0x43C2'0000:
        if (offset == 0x10) illegal &= ~value;
        return;
      case 0x43C3'0000:
        if (value != selected_) position_ += switch_artefact;
        selected_ = value;
        return;
      default:
        ADD_FAILURE() << "write to 0x" << std::hex << addr.value;
    }
  }

  Interrupts wait_for_interrupt(Interrupts) noexcept override {
    pass(next_trigger_ - now_);
    return Interrupts::kTimer;
  }
  void send_event() noexcept override {}
  Cycles now() noexcept override { return Cycles{now_}; }
  void charge(Work, std::int64_t) noexcept override {}

 private:
  static std::int64_t toggles(std::int64_t width) { return width == 0 ? 0 : (kTick - 1) / std::abs(width); }
  static std::int64_t count(std::int64_t width) {
    const std::int64_t pulses = (toggles(width) + 1) / 2;
    return width < 0 ? -pulses : pulses;
  }

  void trigger() {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const std::int64_t pulses = count(active_[axis]);
      emitted[axis] += pulses;
      if (axis == selected_) position_ += pulses;
      snapshot_[axis] = emitted[axis];
      const std::int64_t next = ((armed_ >> axis) & 1u) != 0 ? widths_[axis] : 0;
      judge_direction(axis, next);
      active_[axis] = next;
    }
    position_snapshot_ = position_;
    trigger_time_ = next_trigger_;
    next_trigger_ += kTick;
    ++triggers;
  }

  void judge_direction(std::size_t axis, std::int64_t next) {
    const std::int64_t before = active_[axis];
    if (next == 0 || (next > 0) == forward_[axis]) return;
    forward_[axis] = next > 0;
    EXPECT_GE(std::abs(next), kDirTime) << "set-up of axis " << axis + 1 << " at trigger " << triggers;
    if (before == 0) return;
    EXPECT_EQ(toggles(before) % 2, 0) << "axis " << axis + 1 << " turns while step is high, trigger " << triggers;
    EXPECT_GE(kTick - toggles(before) * std::abs(before), kDirTime) << "hold of axis " << axis + 1;
  }

  std::int64_t now_ = 100;
  std::int64_t next_trigger_ = 0;  // 0: the timer stands
  std::int64_t trigger_time_ = 0;
  PerAxis<std::int64_t> widths_{}, active_{}, snapshot_{};
  PerAxis<bool> forward_{};
  std::uint32_t armed_ = 0;
  bool estop_ = false;
  std::size_t selected_ = 0;
  std::int64_t position_ = 0, position_snapshot_ = 0;
};

}  // namespace armature::test
