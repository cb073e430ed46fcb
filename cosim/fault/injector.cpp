#include "cosim/fault/injector.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <variant>

#include "controller/regs/soc_map.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

std::size_t index_of(int axis) {
  return static_cast<std::size_t>(axis - 1);
}

}  // namespace

void FaultInjector::begin(const FaultKind& kind, Cycles now) {
  now_ = now;
  std::visit(
      [&]<class Kind>(const Kind& fault) {
        if constexpr (FaultWithDuration<Kind>) active_.add(kind);
        start(fault);
      },
      kind);
  follow_clock();
}

void FaultInjector::end(const FaultKind& kind, Cycles now) {
  now_ = now;
  std::visit(
      [&]<class Kind>(const Kind& fault) {
        if constexpr (FaultWithDuration<Kind>) {
          active_.remove(kind);
          stop(fault);
        }
      },
      kind);
  follow_clock();
}

void FaultInjector::follow_clock() {
  if (clock_runs() == clock_ran_) return;
  clock_ran_ = clock_runs();
  targets_.soc.set_clock_running(clock_ran_);
}

void FaultInjector::apply_to(SocInputs& pins) const {
  lines_.apply_to(pins);
  if (active_.any<Estop>()) pins.estop_n = false;
}

std::uint8_t FaultInjector::seen_interrupts(std::uint8_t levels) const {
  constexpr unsigned kTimer = 1u << regs::soc::kAxiTimerIrq, kUart = 1u << regs::soc::kAxiUart16550Irq;
  const unsigned hidden = (active_.any<InterruptLost>() ? kTimer : 0u) | (active_.any<UartOverrun>() ? kUart : 0u);
  return static_cast<std::uint8_t>(levels & ~hidden);
}

Cycles FaultInjector::response_delay() const {
  Cycles delay{};
  active_.for_each<SlowSlave>([&](const SlowSlave& slow) { delay += to_cycles(slow.delay_us * 1e-6); });
  return delay;
}

bool FaultInjector::takes_for_error(std::uint32_t address) {
  const auto found = std::ranges::find(errors_, std::int64_t{address}, &SlaveError::address);
  if (found == errors_.end()) return false;
  if (--found->count == 0) errors_.erase(found);
  return true;
}

void FaultInjector::start(const PulseLoss& fault) {
  targets_.plant.drop_pulses(index_of(fault.axis), fault.count);
}

void FaultInjector::start(const SlowCore& fault) {
  targets_.processor.set_tick_compute(to_cycles(fault.compute_us * 1e-6));
}

void FaultInjector::start(const StrayWrite& fault) {
  targets_.processor.write_astray(static_cast<std::uint32_t>(fault.address), static_cast<std::uint32_t>(fault.data));
}

void FaultInjector::start(const BlockHang& fault) {
  blocks_hang_ = true;
  motion_hangs_ = motion_hangs_ || fault.clock != ClockGroup::kIo;
  targets_.soc.stop_clock_of(fault.clock);
}

void FaultInjector::start(const ExtraPulses& fault) {
  targets_.plant.double_pulses(index_of(fault.axis), fault.count);
}

void FaultInjector::start(const DriveAlarm& fault) {
  targets_.plant.trip_drive(index_of(fault.axis), now_);
}
void FaultInjector::stop(const DriveAlarm& fault) {
  targets_.plant.repair_drive(index_of(fault.axis));
}

void FaultInjector::start(const AxisBlocked& fault) {
  targets_.plant.block(index_of(fault.axis));
}
void FaultInjector::stop(const AxisBlocked& fault) {
  targets_.plant.unblock(index_of(fault.axis));
}

// Of several faults of a brake the worst one counts.
void FaultInjector::set_brake(int axis) {
  double share = 1.0;
  active_.for_each<BrakeSlip>([&](const BrakeSlip& slip) {
    if (slip.axis == axis) share = std::min(share, slip.share);
  });
  targets_.plant.weaken_brake(index_of(axis), share, now_);
}

// Several torques add up.
void FaultInjector::set_push(int axis) {
  double torque_nm = 0;
  active_.for_each<CollisionTorque>([&](const CollisionTorque& push) {
    if (push.axis == axis) torque_nm += push.torque_nm;
  });
  targets_.plant.push(index_of(axis), torque_nm, now_);
}

void FaultInjector::start(const CoreOneStuck&) {
  targets_.processor.stop_core_one(now_);
}

void FaultInjector::start(const SlaveError& fault) {
  bus_errs_ = true;
  errors_.push_back(fault);
}

void FaultInjector::start(const RegisterFlip& fault) {
  targets_.processor.flip_astray(static_cast<std::uint32_t>(fault.address), std::uint32_t{1} << fault.bit);
}

void FaultInjector::start(const FlopFlip& fault) {
  if (!targets_.soc.flip(fault.flop, fault.bit)) throw std::invalid_argument{"no flop " + fault.flop};
  flops_flipped_ = true;
}

void FaultInjector::start(const MemoryFlip& fault) {
  const auto address = targets_.processor.memory().word_at(fault.symbol, fault.offset);
  if (!address) throw std::invalid_argument{"no memory at " + fault.symbol};
  targets_.processor.flip_memory(*address, std::uint32_t{1} << fault.bit);
  bus_errs_ = true;
}

}  // namespace armature::cosim
