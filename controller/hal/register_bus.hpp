// The only access of the controller to hardware and time.
//
// On the robot the functions are memory-mapped accesses, a wait-for-interrupt instruction and a cycle counter. In the
// simulation every call suspends the calling core until its AXI4-Lite transaction has finished in the RTL. An error
// response or a time-out ends the run or stops the core, so callers need no error handling.
#pragma once

#include <cstddef>
#include <cstdint>

#include "controller/base/units.hpp"

namespace armature {

// A byte address of the programmable logic in the address map of the ARM cores.
struct RegAddr {
  std::uint32_t value = 0;
  friend constexpr RegAddr operator+(RegAddr base, std::uint32_t offset) noexcept { return {base.value + offset}; }
  friend constexpr bool operator==(RegAddr, RegAddr) noexcept = default;
};

// Interrupt lines of one core, as a mask.
enum class Interrupts : std::uint32_t {
  kNone = 0,
  kTimer = 1u << 0,   // irq_o[0] of the programmable logic: the 50 us trigger; a level until acknowledged
  kUart = 1u << 1,    // irq_o[1]: the serial line; a level until its cause is removed
  kGpio = 1u << 2,    // irq_o[2]: an input of the tool changed; a level until acknowledged
  kEvent = 1u << 31,  // send_event() of the other core or a new command from outside; cleared when returned
};

[[nodiscard]] constexpr Interrupts operator|(Interrupts a, Interrupts b) noexcept {
  return static_cast<Interrupts>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
[[nodiscard]] constexpr Interrupts operator&(Interrupts a, Interrupts b) noexcept {
  return static_cast<Interrupts>(static_cast<std::uint32_t>(a) & static_cast<std::uint32_t>(b));
}

// Named pieces of computation. A simulated core charges their cost in clock cycles; real hardware ignores them.
enum class Work : std::uint8_t {
  kInterruptEntry,  // latency from the interrupt line to the first instruction of the handler
  kTick,            // one tick: conversions, sampler, quantizer, feedback
  kPlan,            // one joint-space plan, or the begin of a path
  kRetarget,        // one joint-space plan from a state of motion: in a tick, or for one trial of a corner with a path
  kCorner,          // one trial of a corner between joint moves: a plan, and how near it passes the corner
  kWindow,          // the begin of a further part of a path that is executed
  kInverse,         // one inverse kinematics on a path: in a tick, or for one sample of a plan's check
  kProgramStep,     // one step of a program: a line, or a part of it
  kNetwork,         // one run of the network that corrects a belt, in a tick
};
inline constexpr std::size_t kWorks = static_cast<std::size_t>(Work::kNetwork) + 1;

class RegisterBus {
 public:
  // One 32-bit access; returns after the response. Addresses are multiples of 4.
  [[nodiscard]] virtual std::uint32_t read32(RegAddr addr) noexcept = 0;
  virtual void write32(RegAddr addr, std::uint32_t value) noexcept = 0;

  // Sleeps until one of the lines in `mask` is active and returns those that are. Returns at once if one already is.
  // kNone ends the main of the core; a test's bus returns it at the end of the test. Hardware and simulated cores never
  // return it: they end by executing nothing more.
  virtual Interrupts wait_for_interrupt(Interrupts mask) noexcept = 0;

  // Wakes the other core with Interrupts::kEvent. The event is never lost: if that core is awake, its next wait returns
  // at once.
  virtual void send_event() noexcept = 0;

  // Time since reset in clock cycles of the programmable logic, by a timer of the processor: it continues while the
  // clock of the logic stands still.
  [[nodiscard]] virtual Cycles now() noexcept = 0;

  // Charges a simulated core for a computation that was just made `times` times.
  virtual void charge(Work work, std::int64_t times = 1) noexcept = 0;

 protected:
  ~RegisterBus() = default;  // never owned through this interface
};

}  // namespace armature
