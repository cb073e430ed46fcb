#include "cosim/cpu/core.hpp"

#include <algorithm>
#include <utility>

#include "cosim/time/never.hpp"

namespace armature::cosim {
namespace {

constexpr std::uint32_t bits(Interrupts lines) {
  return static_cast<std::uint32_t>(lines);
}

// Whether all work of core 0 takes time. Work that takes none ends in the same cycle or in the next one: that depends
// on what the simulation does in this cycle, which a core that is ahead does not know.
bool takes_time(const CpuSpec& spec) {
  return spec.cpi || std::min({spec.interrupt_entry_cycles, spec.tick_compute_cycles, spec.retarget_compute_cycles,
                               spec.inverse_compute_cycles}) > 0;
}

}  // namespace

Core::Core(int number, const CpuSpec& spec, Main main)
    : number_{number}, spec_{spec}, takes_time_{takes_time(spec)}, fiber_{[this, main = std::move(main)] {
        try {
          main(*this);
        } catch (...) {
          failure_ = std::current_exception();
        }
        wait_ = Wait::kHalted;
      }} {}

void Core::run_ahead(RunAhead& simulation, const Core& other) {
  simulation_ = &simulation;
  other_ = &other;
}

CoreState Core::state() const {
  switch (wait_) {
    case Wait::kInterrupt:
      return CoreState::kWaiting;
    case Wait::kBus:
      return CoreState::kBus;
    case Wait::kHalted:
      return CoreState::kHalted;
    case Wait::kNothing:
    case Wait::kTime:
      break;
  }
  return CoreState::kComputing;
}

Cycles Core::longest_awake(Cycles now) const {
  return is_awake() ? std::max(longest_awake_, now - awake_since_) : longest_awake_;
}

Cycles Core::awake(Cycles now) const {
  return is_awake() ? awake_ + (now - awake_since_) : awake_;
}

std::optional<Cycles> Core::wakes_at() const {
  if (wait_ == Wait::kTime) return wake_;
  return std::nullopt;
}

void Core::run_if_due(Cycles now) {
  if (wait_ == Wait::kTime && wake_ <= now) resume(now);
}

void Core::complete(const BusResponse& response, Cycles now) {
  response_ = response;
  request_.reset();
  resume(now);
}

void Core::halt(Cycles now) {
  longest_awake_ = longest_awake(now);
  awake_ = awake(now);
  request_.reset();
  wait_ = Wait::kHalted;
}

void Core::set_tick_compute(std::int64_t cycles) {
  spec_.tick_compute_cycles = cycles;
  takes_time_ = takes_time(spec_);
}

std::optional<std::uint64_t> Core::waiting_digest() const {
  if (wait_ != Wait::kInterrupt) return std::nullopt;
  return std::uint64_t{bits(mask_)} << 32 | std::uint64_t{bits(levels_)} << 2 | (event_ ? 2u : 0u) |
         (event_sent_ ? 1u : 0u);
}

void Core::set_event(Cycles now) {
  event_ = true;
  wake_if_interrupted(now);
}

bool Core::pop_event_sent() {
  return std::exchange(event_sent_, false);
}

void Core::wake_if_interrupted(Cycles now) {
  if (wait_ == Wait::kInterrupt && active(mask_) != Interrupts::kNone) resume(now);
}

void Core::resume(Cycles now) {
  time_.now = now;
  is_ahead_ = false;
  wait_ = Wait::kNothing;
  fiber_.resume();
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

Interrupts Core::active(Interrupts mask) const {
  const std::uint32_t lines = bits(levels_) | (event_ ? bits(Interrupts::kEvent) : 0u);
  return static_cast<Interrupts>(lines & bits(mask));
}

// ---- called from inside the fiber ----

bool Core::may_run_ahead() const {
  return simulation_ != nullptr && takes_time_ && !event_sent_ && !simulation_->host_must_read();
}

// The cycle before which the core does nothing unless it is notified or interrupted; 0 if it may do something now.
Cycles Core::quiet_until() const {
  switch (wait_) {
    case Wait::kInterrupt:
      return active(mask_) == Interrupts::kNone ? kNever : Cycles{0};
    case Wait::kHalted:
      return kNever;
    case Wait::kTime:
      return wake_;
    case Wait::kBus:
    case Wait::kNothing:
      break;
  }
  return Cycles{0};
}

// Suspends the core in the cycle in which it is.
void Core::wait_for_simulation() {
  if (!is_ahead_) return;
  simulation_->catch_up(time_.now);
  sleep_until(time_.now);
}

// So often that a call would cost as much as the work.
[[gnu::always_inline]] inline std::uint32_t Core::access(const BusRequest& request) {
  if (!is_ahead_) time_.horizon = find_horizon();
  RunAhead::Outcome outcome;
  if (time_.now < time_.horizon) outcome = simulation_->try_access(request, time_);
  if (outcome.access != RunAhead::Access::kDone) [[unlikely]]
    return wait_for_response(request, outcome.access);
  is_ahead_ = true;
  return outcome.data;
}

// The cycle before which a core that is not ahead runs alone; its own cycle or an earlier one if it does not.
Cycles Core::find_horizon() const {
  return may_run_ahead() ? std::min(simulation_->horizon(), other_->quiet_until()) : time_.now;
}

// Of an access that has begun, or that begins when the simulation is where the core is.
std::uint32_t Core::wait_for_response(const BusRequest& request, RunAhead::Access access) {
  if (access == RunAhead::Access::kRefused) wait_for_simulation();
  request_ = request;
  wait_ = Wait::kBus;
  fiber_.suspend();
  return response_.data;
}

std::uint32_t Core::read32(RegAddr addr) noexcept {
  return access({.write = false, .addr = addr.value, .data = 0});
}

void Core::write32(RegAddr addr, std::uint32_t value) noexcept {
  access({.write = true, .addr = addr.value, .data = value});
}

void Core::sleep_until(Cycles cycle) {
  wake_ = cycle;
  wait_ = Wait::kTime;
  fiber_.suspend();
}

void Core::send_event() noexcept {
  wait_for_simulation();
  event_sent_ = true;
}

Interrupts Core::wait_for_interrupt(Interrupts mask) noexcept {
  if (is_ahead_ && simulation_->host_must_read()) wait_for_simulation();
  longest_awake_ = std::max(longest_awake_, time_.now - awake_since_);
  awake_ += time_.now - awake_since_;
  if (active(mask) == Interrupts::kNone) {
    mask_ = mask;
    wait_ = Wait::kInterrupt;
    fiber_.suspend();
  }
  awake_since_ = time_.now;
  const Interrupts lines = active(mask);
  if ((bits(lines) & bits(Interrupts::kEvent)) != 0) event_ = false;
  return lines;
}

// Whether this core runs alone up to and at the cycle `until`; then time_.horizon is known.
bool Core::passes_alone(Cycles until) {
  if (is_ahead_) return until < time_.horizon && !simulation_->host_must_read();
  if (!may_run_ahead() || until >= other_->quiet_until()) return false;
  time_.horizon = std::min(simulation_->pass_time(until), other_->quiet_until());
  return until < time_.horizon;
}

void Core::charge(Work work, std::int64_t times) noexcept {
  const Cycles cost{cycles_of(spec_, work) * times};
  if (spec_.cpi) return pass(cost);
  compute_until(time_.now + cost);
}

void Core::pass(Cycles duration) noexcept {
  if (duration > Cycles{}) compute_until(time_.now + duration);
}

void Core::compute_until(Cycles end) {
  if (time_.now < end && passes_alone(end)) {
    is_ahead_ = true;
    time_.now = end;
    return;
  }
  wait_for_simulation();
  sleep_until(end);
}

}  // namespace armature::cosim
