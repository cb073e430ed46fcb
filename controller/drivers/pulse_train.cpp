#include "controller/drivers/pulse_train.hpp"

#include "controller/regs/pulse_train_regs.hpp"

namespace armature {
namespace {

using namespace regs::pulse_train;
using regs::extract;
using regs::extract_axes;
using regs::extract_signed;
using regs::insert;
using regs::insert_signed;

static_assert(kCountCount == kAxes && kEmittedCount == kAxes && kResidualCount == kAxes && kIdAxesReset == kAxes);

std::uint32_t word_of(Cycles cycles) {
  return static_cast<std::uint32_t>(cycles.value());
}

}  // namespace

bool PulseTrain::identified() noexcept {
  return bus_.read32(base_ + kIdOffset) == kIdWord;
}

void PulseTrain::configure(const Config& config) noexcept {
  bus_.write32(base_ + kTickCyclesOffset, insert(0, kTickCyclesValue, word_of(config.tick)));
  bus_.write32(base_ + kDirSetupOffset, insert(0, kDirSetupValue, word_of(config.dir_setup)));
  bus_.write32(base_ + kDirHoldOffset, insert(0, kDirHoldValue, word_of(config.dir_hold)));
  const auto limit = static_cast<std::uint32_t>(config.watchdog_limit.value());
  bus_.write32(base_ + kWatchdogOffset, insert(0, kWatchdogLimit, limit));
}

void PulseTrain::control(std::uint8_t servo_on, bool run) noexcept {
  bus_.write32(base_ + kCtrlOffset, insert(insert(0, kCtrlServoOn, servo_on), kCtrlRun, run ? 1 : 0));
}

void PulseTrain::commit(const PerAxis<Pulses>& counts, std::uint16_t sequence) noexcept {
  for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
    const auto count = static_cast<std::int32_t>(counts[axis].value());
    bus_.write32(base_ + (kCountOffset + axis * kCountStride), insert_signed(0, kCountValue, count));
  }
  bus_.write32(base_ + kCommitOffset, insert(0, kCommitSequence, sequence));
}

PulseTrain::Status PulseTrain::status() noexcept {
  const std::uint32_t word = bus_.read32(base_ + kStatusOffset);
  return {.estop = (word & kStatusEstopMask) != 0,
          .watchdog = (word & kStatusWatchdogMask) != 0,
          .estop_pin = (word & kStatusEstopPinMask) != 0,
          .pending = (word & kStatusPendingMask) != 0,
          .sequence = static_cast<std::uint16_t>(extract(word, kStatusSequence))};
}

PulseTrain::Faults PulseTrain::faults() noexcept {
  const std::uint32_t word = bus_.read32(base_ + kFaultOffset);
  return {.estop = (word & kFaultEstopMask) != 0,
          .watchdog = (word & kFaultWatchdogMask) != 0,
          .underrun = (word & kFaultUnderrunMask) != 0,
          .residual = (word & kFaultResidualMask) != 0,
          .clipped = (word & kFaultClippedMask) != 0,
          .recommit = (word & kFaultRecommitMask) != 0};
}

void PulseTrain::clear(const Faults& faults) noexcept {
  std::uint32_t word = 0;
  if (faults.estop) word |= kFaultEstopMask;
  if (faults.watchdog) word |= kFaultWatchdogMask;
  if (faults.underrun) word |= kFaultUnderrunMask;
  if (faults.residual) word |= kFaultResidualMask;
  if (faults.clipped) word |= kFaultClippedMask;
  if (faults.recommit) word |= kFaultRecommitMask;
  bus_.write32(base_ + kFaultOffset, word);
}

std::uint32_t PulseTrain::underruns() noexcept {
  return bus_.read32(base_ + kUnderrunsOffset);
}

PerAxis<std::int32_t> PulseTrain::emitted() noexcept {
  PerAxis<std::int32_t> pulses;
  for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
    pulses[axis] = extract_signed(bus_.read32(base_ + (kEmittedOffset + axis * kEmittedStride)), kEmittedValue);
  }
  return pulses;
}

PerAxis<std::int32_t> PulseTrain::residual() noexcept {
  PerAxis<std::int32_t> pulses;
  for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
    pulses[axis] = extract_signed(bus_.read32(base_ + (kResidualOffset + axis * kResidualStride)), kResidualValue);
  }
  return pulses;
}

PulseTrain::Switches PulseTrain::switches() noexcept {
  const std::uint32_t word = bus_.read32(base_ + kSwitchesOffset);
  return {.home = extract_axes(word, kSwitchesHome),
          .limit_pos = extract_axes(word, kSwitchesLimitPos),
          .limit_neg = extract_axes(word, kSwitchesLimitNeg)};
}

PulseTrain::Drives PulseTrain::drives() noexcept {
  const std::uint32_t word = bus_.read32(base_ + kDrivesOffset);
  return {.alarm = extract_axes(word, kDrivesAlarm),
          .in_position = extract_axes(word, kDrivesInPosition),
          .servo_on = extract_axes(word, kDrivesServoOn)};
}

void PulseTrain::emergency_stop() noexcept {
  bus_.write32(base_ + kEstopOffset, kEstopStopMask);
}

void PulseTrain::clear_stops() noexcept {
  bus_.write32(base_ + kEstopOffset, kEstopClearEstopMask | kEstopClearWatchdogMask);
}

}  // namespace armature
