// Core 1 of the controller in a thread of its own, on another CPU than core 0 where the machine has two.
//
// What core 1 writes, plans above all, is then in the caches of another core of the machine, as it is on the chip, and
// its work does not evict what core 0 has in its own. Both cores work in turn, so that all runs are equal: core 1
// between two ticks of core 0, until what it has computed takes it beyond the next tick.
#pragma once

#include <sched.h>

#include <atomic>
#include <cstdint>
#include <thread>

#include "controller/app/controller.hpp"
#include "controller/hal/register_bus.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::bench {

class Core1Thread final : private RegisterBus {
 public:
  // The controller must outlive the thread. Binds the calling thread, which is core 0, to one CPU and core 1 to
  // another, if the calling thread may use more than one; until the end.
  explicit Core1Thread(Controller& controller);
  Core1Thread(const Core1Thread&) = delete;
  Core1Thread& operator=(const Core1Thread&) = delete;
  ~Core1Thread();

  // Core 1 works until `now`. `event`: core 0 or the host has something for it.
  void advance(Cycles now, bool event);

 private:
  // RegisterBus. Without a pendant and without tool commands core 1 accesses no register.
  std::uint32_t read32(RegAddr addr) noexcept override;
  void write32(RegAddr addr, std::uint32_t value) noexcept override;
  Interrupts wait_for_interrupt(Interrupts mask) noexcept override;
  void send_event() noexcept override {}
  Cycles now() noexcept override { return now_; }
  void charge(Work work, std::int64_t times) noexcept override;

  void work();
  void give_turn();          // to core 1, and waits until it gives it back
  void end_turn() noexcept;  // of core 1, and waits for the next one
  template <class Condition>
  void wait_until(Condition condition) const noexcept;

  static constexpr cosim::CpuSpec kCost{};

  Controller& controller_;
  cpu_set_t usable_{};  // CPUs before
  bool pair_ = false;   // each thread has a CPU for itself
  // Only the thread that has the turn uses these.
  Cycles now_{}, until_{};
  bool event_ = false, sleeps_ = false, over_ = false;
  std::atomic<std::uint64_t> turns_{0}, turns_over_{0};
  std::thread thread_;  // last: it uses the other members
};

}  // namespace armature::bench
