#include "tests/bench/core1_thread.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <utility>

namespace armature::bench {
namespace {

// The calling thread, to one of these CPUs, counted from 0.
void bind_to_cpu(const cpu_set_t& usable, int index) {
  std::size_t cpu = 0;
  while (!CPU_ISSET(cpu, &usable) || index-- > 0) ++cpu;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(cpu, &one);
  (void)sched_setaffinity(0, sizeof one, &one);
}

}  // namespace

Core1Thread::Core1Thread(Controller& controller) : controller_{controller} {
  pair_ = sched_getaffinity(0, sizeof usable_, &usable_) == 0 && CPU_COUNT(&usable_) >= 2;
  thread_ = std::thread{[this] { work(); }};
  if (pair_) bind_to_cpu(usable_, 0);
}

Core1Thread::~Core1Thread() {
  over_ = true;
  give_turn();
  thread_.join();
  if (pair_) (void)sched_setaffinity(0, sizeof usable_, &usable_);
}

void Core1Thread::advance(Cycles now, bool event) {
  event_ = event_ || event;
  if (sleeps_ ? !event_ : now_ > now) return;
  until_ = now;
  give_turn();
}

void Core1Thread::give_turn() {
  const std::uint64_t turn = turns_.fetch_add(1, std::memory_order_release) + 1;
  wait_until([&] { return turns_over_.load(std::memory_order_acquire) == turn; });
}

void Core1Thread::end_turn() noexcept {
  const std::uint64_t over = turns_over_.fetch_add(1, std::memory_order_release) + 1;
  wait_until([&] { return turns_.load(std::memory_order_acquire) > over; });
}

// A thread that has a CPU for itself looks again and again: a call of the system would put other code and data into
// its caches.
template <class Condition>
void Core1Thread::wait_until(Condition condition) const noexcept {
  while (!condition()) {
    if (!pair_) std::this_thread::yield();
  }
}

void Core1Thread::work() {
  if (pair_) bind_to_cpu(usable_, 1);
  wait_until([&] { return turns_.load(std::memory_order_acquire) > 0; });
  controller_.core1_main(*this);
  turns_over_.fetch_add(1, std::memory_order_release);
}

std::uint32_t Core1Thread::read32(RegAddr) noexcept {
  std::abort();
}

void Core1Thread::write32(RegAddr, std::uint32_t) noexcept {
  std::abort();
}

// At the end of the run core 1 is switched off.
Interrupts Core1Thread::wait_for_interrupt(Interrupts) noexcept {
  sleeps_ = true;
  while (!event_ && !over_) end_turn();
  sleeps_ = false;
  now_ = std::max(now_, until_);
  return !over_ && std::exchange(event_, false) ? Interrupts::kEvent : Interrupts::kNone;
}

void Core1Thread::charge(Work work, std::int64_t times) noexcept {
  now_ = now_ + Cycles{cosim::cycles_of(kCost, work) * times};
  while (now_ > until_ && !over_) end_turn();
}

}  // namespace armature::bench
