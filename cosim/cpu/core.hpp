// One simulated ARM core: runs a controller main as a fiber and charges its time in clock cycles of the logic.
//
// Between two calls of RegisterBus the core takes no simulated time. Every call may suspend it. The simulation
// continues the core when its time has passed, its bus request is complete, or an interrupt is active. A core that may
// run ahead (run_ahead.hpp) is then at a later cycle than the simulation, until it is suspended.
//
// At the end of a run the simulation does not continue the core any more, and the destructor frees its stack. No
// further code of the main runs, so a run that is interrupted while core 1 plans a long path ends at once. Therefore
// objects on the stack of a main must own nothing (see Fiber).
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>

#include "cosim/bus/axi_lite_master.hpp"
#include "cosim/cpu/core_bus.hpp"
#include "cosim/cpu/cpu_spec.hpp"
#include "cosim/cpu/fiber.hpp"
#include "cosim/cpu/processor.hpp"
#include "cosim/cpu/run_ahead.hpp"

namespace armature::cosim {

class Core final : private CoreBus {
 public:
  using Main = std::function<void(CoreBus&)>;

  Core(int number, const CpuSpec& spec, Main main);
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;

  // From now on the core may run ahead, up to the horizon of the simulation and of `other`, which never runs ahead.
  void run_ahead(RunAhead& simulation, const Core& other);

  [[nodiscard]] int number() const { return number_; }

  [[nodiscard]] CoreState state() const;

  // ---- time: cycle at which the core continues, if it waits for time to pass
  [[nodiscard]] std::optional<Cycles> wakes_at() const;
  // Continues the core if it is due at `now`. Throws what ends its main, as all that continues it.
  void run_if_due(Cycles now);

  // ---- bus: the request for which the core waits, until complete() passes the response
  [[nodiscard]] const std::optional<BusRequest>& bus_request() const { return request_; }
  void complete(const BusResponse& response, Cycles now);
  // The core executes nothing more.
  void halt(Cycles now);

  // ---- interrupts: levels of the programmable logic, and the event line
  void set_interrupt_levels(Interrupts levels) { levels_ = levels; }
  // Continues the core if it waits for an interrupt that is active.
  void wake_if_interrupted(Cycles now);
  void set_event(Cycles now);
  // True when this core has called send_event() since the last call.
  bool pop_event_sent();

  // For what the core waits, and what has come meanwhile; none: it does not wait for an interrupt.
  [[nodiscard]] std::optional<std::uint64_t> waiting_digest() const;

  // Sets the computation time of a tick from now on (fault script).
  void set_tick_compute(std::int64_t cycles);

  // The longest time between two calls of wait_for_interrupt until `now`: the duration of the worst tick.
  [[nodiscard]] Cycles longest_awake(Cycles now) const;
  void reset_longest_awake() { longest_awake_ = Cycles{}; }
  // The time until `now` in which the core did not wait for an interrupt: it computed or waited for the bus.
  [[nodiscard]] Cycles awake(Cycles now) const;

 private:
  enum class Wait : std::uint8_t { kNothing, kTime, kBus, kInterrupt, kHalted };

  std::uint32_t read32(RegAddr addr) noexcept override;
  void write32(RegAddr addr, std::uint32_t value) noexcept override;
  Interrupts wait_for_interrupt(Interrupts mask) noexcept override;
  void send_event() noexcept override;
  Cycles now() noexcept override { return time_.now; }
  void charge(Work work, std::int64_t times) noexcept override;
  void pass(Cycles duration) noexcept override;

  std::uint32_t access(const BusRequest& request);
  std::uint32_t wait_for_response(const BusRequest& request, RunAhead::Access access);
  [[nodiscard]] Cycles find_horizon() const;
  [[nodiscard]] bool may_run_ahead() const;
  [[nodiscard]] bool passes_alone(Cycles until);
  [[nodiscard]] Cycles quiet_until() const;
  void wait_for_simulation();
  void compute_until(Cycles end);
  void sleep_until(Cycles cycle);
  [[nodiscard]] bool is_awake() const { return wait_ != Wait::kInterrupt && wait_ != Wait::kHalted; }
  [[nodiscard]] Interrupts active(Interrupts mask) const;
  void resume(Cycles now);

  int number_;
  CpuSpec spec_;
  bool takes_time_;  // all work of core 0 that suspends it
  Fiber fiber_;
  Wait wait_ = Wait::kTime;  // starts at cycle 0
  TimeAhead time_;           // horizon: of a core that is ahead
  Cycles wake_{};
  Cycles awake_since_{};
  Cycles longest_awake_{};
  Cycles awake_{};  // before awake_since_
  std::optional<BusRequest> request_;
  BusResponse response_;
  Interrupts levels_ = Interrupts::kNone;
  Interrupts mask_ = Interrupts::kNone;
  bool event_ = false;
  bool event_sent_ = false;
  RunAhead* simulation_ = nullptr;
  const Core* other_ = nullptr;
  std::exception_ptr failure_;  // has ended the main
  bool is_ahead_ = false;       // since it was continued it has run ahead
};

}  // namespace armature::cosim
