#include "tests/controller/support/fake_logic.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace armature::test {
namespace {

constexpr std::int64_t kSubStepCycles = 50;  // 1 us
constexpr std::int64_t kSubSteps = 50;
constexpr std::int64_t kTick = kSubSteps * kSubStepCycles;

constexpr std::uint32_t kFlagEstop = 1, kFlagWatchdog = 2, kFlagUnderrun = 4, kFlagResidual = 8, kFlagClipped = 16,
                        kFlagRecommit = 32;

[[noreturn]] void refuse(const char* what, std::uint32_t addr) {
  throw std::logic_error{std::string{what} + " of register " + std::to_string(addr)};
}

}  // namespace

std::int64_t FakeLogic::count(std::size_t axis) const {
  return static_cast<std::int64_t>(std::floor(drives[axis].position + 0.5));
}

void FakeLogic::charge(Work work, std::int64_t times) noexcept {
  pass((work == Work::kTick ? tick_cycles : 50) * times);
}

Interrupts FakeLogic::wait_for_interrupt(Interrupts) noexcept {
  on_wait();
  if (tick_start_ < 0) return Interrupts::kNone;  // would sleep for ever
  while (!interrupt_ && triggers_ < triggers_to_run) pass(tick_start_ + kTick - now_);
  return triggers_ < triggers_to_run ? Interrupts::kTimer : Interrupts::kNone;
}

void FakeLogic::pass(std::int64_t cycles) {
  if (tick_start_ < 0) {
    now_ += cycles;
    return;
  }
  const std::int64_t end = now_ + cycles;
  while (true) {
    const std::int64_t next = tick_start_ + ((now_ - tick_start_) / kSubStepCycles + 1) * kSubStepCycles;
    if (next > end) break;
    now_ = next;
    sub_step((now_ - tick_start_) / kSubStepCycles);
    if (now_ - tick_start_ == kTick) trigger();
  }
  now_ = end;
}

// One microsecond: pulses that fall into it, then the drives.
void FakeLogic::sub_step(std::int64_t index) {
  if (estop_pin && !estop_) {
    estop_ = true;
    flags_ |= kFlagEstop;
  }
  const std::uint32_t servo = servo_on() & ~alarm;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    Drive& drive = drives[axis];
    const bool on = ((servo >> axis) & 1u) != 0;
    const bool was_on = ((servo_was_ >> axis) & 1u) != 0;
    if (on && !was_on) drive.reference = std::floor(drive.position + 0.5);
    const std::int64_t size = std::llabs(active_.counts[axis]) - cut_[axis];
    const std::int64_t direction = active_.counts[axis] < 0 ? -1 : 1;
    const std::int64_t due = (2 * index * size + kSubSteps) / (2 * kSubSteps);
    for (; !stopped() && in_tick_[axis] < due; ++in_tick_[axis]) {
      emitted_[axis] += direction;
      if (!on || drive.lose > 0) {
        if (on) --drive.lose;
        drive.dropped += direction;
      } else {
        drive.reference += static_cast<double>(direction) * drive.counts_per_pulse;
      }
    }
    if (on && !drive.stuck) {
      const double h = 1e-6, wn = drive.natural_rad_s, friction = 2.0 * drive.damping * wn;
      const auto accel = [&](double x, double v) { return wn * wn * (drive.reference - x) - friction * v; };
      const double v = drive.speed + 0.5 * h * accel(drive.position, drive.speed);
      const double x = drive.position + 0.5 * h * drive.speed;
      drive.position += h * v;
      drive.speed += h * accel(x, v);
    } else {
      drive.speed = 0.0;
    }
  }
  servo_was_ = servo;
}

void FakeLogic::trigger() {
  tick_start_ = now_;
  interrupt_ = true;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::int64_t missing = std::llabs(active_.counts[axis]) - in_tick_[axis];
    residual_[axis] += active_.counts[axis] < 0 ? -missing : missing;
    if (missing != 0) flags_ |= kFlagResidual;
  }
  emitted_snapshot_ = emitted_;
  for (std::size_t axis = 0; axis < kAxes; ++axis) position_snapshot_[axis] = count(axis);
  encoder_flags_ |= encoder_fault;
  encoder_fault = 0;
  in_tick_ = {};
  cut_ = {};
  if (stopped()) {
    // A stop discards commits and expects none.
    active_.counts = {};
    pending_ = false;
    in_a_row_ = 0;
  } else if (pending_) {
    pending_ = false;
    in_a_row_ = 0;
    active_ = pending_set_;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      largest_count_ = std::max<std::int64_t>(largest_count_, std::abs(active_.counts[axis]));
      cut_[axis] = std::min<std::int64_t>(shorten[axis], std::abs(active_.counts[axis]));
      shorten[axis] -= cut_[axis];
    }
  } else {
    active_.counts = {};
    if (run_) {
      ++underruns_;
      flags_ |= kFlagUnderrun;
      if (++in_a_row_ >= watchdog_limit_ && !watchdog_) {
        watchdog_ = true;
        flags_ |= kFlagWatchdog;
      }
    }
  }
  const std::int64_t number = triggers_++;
  if (on_trigger) on_trigger(number);
}

std::uint32_t FakeLogic::read32(RegAddr addr) noexcept {
  pass(kAccessCycles);
  const std::uint32_t offset = addr.value & 0xFFFFu;
  if ((addr.value & 0xFFFF'0000u) == 0x43C1'0000u) return read_pulse_train(offset);
  if ((addr.value & 0xFFFF'0000u) != 0x43C2'0000u) refuse("read", addr.value);
  if (offset == 0x00) return encoder_id;
  if (offset == 0x10) return encoder_flags_;
  if (offset == 0x1C) return encoder_known;
  if (offset >= 0x20 && offset < 0x38) return static_cast<std::uint32_t>(position_snapshot_[(offset - 0x20) / 4]);
  refuse("read", addr.value);
}

std::uint32_t FakeLogic::read_pulse_train(std::uint32_t offset) const {
  if (offset >= 0x60 && offset < 0x78) return static_cast<std::uint32_t>(emitted_snapshot_[(offset - 0x60) / 4]);
  if (offset >= 0x80 && offset < 0x98) return static_cast<std::uint32_t>(residual_[(offset - 0x80) / 4]);
  switch (offset) {
    case 0x00:
      return pulse_train_id;
    case 0x08:
      return (estop_ ? 1u : 0u) | (watchdog_ ? 2u : 0u) | (estop_pin ? 4u : 0u) | (pending_ ? 8u : 0u) |
             (std::uint32_t{active_.sequence} << 16);
    case 0x10:
      return flags_;
    case 0x18:
      return underruns_;
    case 0x30:
      return (limit_pos << 8) | (limit_neg << 16);
    case 0x34:
      return alarm;
    default:
      refuse("read", offset);
  }
}

void FakeLogic::write32(RegAddr addr, std::uint32_t value) noexcept {
  pass(kAccessCycles);
  const std::uint32_t offset = addr.value & 0xFFFFu;
  switch (addr.value & 0xFFFF'0000u) {
    case 0x43C1'0000u:
      return write_pulse_train(offset, value);
    case 0x43C2'0000u:
      if (offset == 0x10) encoder_flags_ &= ~value;
      return;
    case 0x4280'0000u:
      if (offset == 0x04) tlr_ = value;
      if (offset != 0x00) return;
      if ((value & 0x100u) != 0) interrupt_ = false;
      tcsr_ = value & ~0x100u;
      if ((tcsr_ & 0x80u) != 0 && tick_start_ < 0) {
        if (tlr_ + 2 != kTick) refuse("wrong period", tlr_);
        tick_start_ = now_;
        // As left by the last trigger before a restart of the software.
        for (std::size_t axis = 0; axis < kAxes; ++axis) position_snapshot_[axis] = count(axis);
      }
      return;
    default:
      refuse("write", addr.value);
  }
}

void FakeLogic::write_pulse_train(std::uint32_t offset, std::uint32_t value) {
  if (offset >= 0x40 && offset < 0x58) {
    staged_.counts[(offset - 0x40) / 4] = static_cast<std::int16_t>(value);
    return;
  }
  switch (offset) {
    case 0x04:
      servo_request_ = value & 0x3Fu;
      run_ = (value & 0x100u) != 0;
      return;
    case 0x0C:
      if ((value & 1u) != 0) estop_ = true;
      if ((value & 2u) != 0 && !estop_pin) estop_ = false;
      if ((value & 4u) != 0) {
        watchdog_ = false;
        in_a_row_ = 0;
      }
      return;
    case 0x10:
      flags_ &= ~value;
      return;
    case 0x14:
      watchdog_limit_ = value & 0xFFu;
      return;
    case 0x28:
      if (stopped()) return;
      if (pending_) {
        flags_ |= kFlagRecommit;
        ++recommits_;
      }
      for (std::int16_t& count : staged_.counts) {
        if (std::abs(count) > 200) flags_ |= kFlagClipped;
        count = std::clamp<std::int16_t>(count, -200, 200);
      }
      pending_set_ = staged_;
      pending_set_.sequence = static_cast<std::uint16_t>(value);
      pending_ = true;
      return;
    case 0x1C:
      if (value != kTick) refuse("wrong tick", value);
      return;
    case 0x20:
      dir_setup_ = value & 0x3FFu;
      return;
    case 0x24:
      dir_hold_ = value & 0x3FFu;
      return;
    default:
      refuse("write", offset);
  }
}

}  // namespace armature::test
