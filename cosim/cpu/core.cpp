#include "cosim/cpu/core.hpp"

#include <algorithm>
#include <utility>

namespace armature::cosim {
namespace {

constexpr std::uint32_t bits(Interrupts lines) {
  return static_cast<std::uint32_t>(lines);
}

}  // namespace

Core::Core(int number, const CpuSpec& spec, Main main)
    : number_{number}, spec_{spec}, fiber_{[this, main = std::move(main)] { main(*this); }} {}

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

void Core::set_interrupt_levels(Interrupts levels, Cycles now) {
  levels_ = levels;
  wake_if_interrupted(now);
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
  now_ = now;
  wait_ = Wait::kNothing;
  fiber_.resume();
}

Interrupts Core::active(Interrupts mask) const {
  const std::uint32_t lines = bits(levels_) | (event_ ? bits(Interrupts::kEvent) : 0u);
  return static_cast<Interrupts>(lines & bits(mask));
}

// ---- called from inside the fiber ----

std::uint32_t Core::access(const BusRequest& request) {
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

Interrupts Core::wait_for_interrupt(Interrupts mask) noexcept {
  longest_awake_ = std::max(longest_awake_, now_ - awake_since_);
  awake_ += now_ - awake_since_;
  if (active(mask) == Interrupts::kNone) {
    mask_ = mask;
    wait_ = Wait::kInterrupt;
    fiber_.suspend();
  }
  awake_since_ = now_;
  const Interrupts lines = active(mask);
  if ((bits(lines) & bits(Interrupts::kEvent)) != 0) event_ = false;
  return lines;
}

void Core::charge(Work work, std::int64_t times) noexcept {
  sleep_until(now_ + Cycles{cycles_of(spec_, work) * times});
}

}  // namespace armature::cosim
