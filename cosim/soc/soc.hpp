// Interface of the chip for its processor and its surroundings: register accesses, interrupts, pins, one clock.
//
// Simulation and `armature serve` are the clients. They must not assume which engine computes the logic, nor that it
// computes single clock edges: an engine may compute many cycles at once.
//
// Time: all events are at clock edges. At now() the outputs show the state after that edge. Inputs that are set at
// now() are sampled by the next edge.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/bus/bus_access.hpp"
#include "cosim/bus/time_ahead.hpp"
#include "cosim/fabric/fabric.hpp"
#include "cosim/logic/logic_spec.hpp"
#include "cosim/soc/motion_port.hpp"

namespace armature::cosim {

// Events that end advance() before its limit. The end of an access always does.
enum class StopOn : std::uint8_t {
  kAccess,     // no other event
  kInterrupt,  // a change of an interrupt level
  kPinChange,  // a change of any output pin, interrupts included
};

// Whether the outputs have changed by interrupts that fell, and by nothing else.
[[nodiscard]] inline bool only_interrupts_fell(SocOutputs before, const SocOutputs& after) {
  if ((after.irq & ~before.irq) != 0) return false;
  before.irq = after.irq;
  return before == after;
}

class Soc {
 public:
  virtual ~Soc() = default;

  // ---- time

  // Clock edges since reset was released, with those that a stopped clock would have had.
  [[nodiscard]] virtual Cycles now() const = 0;

  // Runs to cycle `limit`. It stops earlier at the first edge at which an access has finished or a level of `stop_on`
  // has changed. Does nothing when `limit` is not later than now(). Returns whether a level of `stop_on` has changed at
  // now(). Throws LogicCheckFailed when a check inside the logic fails.
  virtual bool advance(Cycles limit, StopOn stop_on) = 0;

  // No output changes before this cycle unless an input changes or an access executes.
  [[nodiscard]] virtual Cycles quiet_until() const { return now(); }

  // Stops the clock of the logic, or lets it run again (fault script). While it is stopped time continues, but the
  // logic and the outputs stay as they are and an access does not end.
  virtual void set_clock_running(bool running) = 0;

  // Stops the gated clock of these blocks for good (fault script). They answer no access any more.
  virtual void stop_clock_of(ClockGroup group) = 0;

  // ---- flops (fault script), as of Fabric
  [[nodiscard]] virtual std::vector<Flop> flops() { return {}; }  // none: the engine has no flops
  virtual bool flip(std::string_view /*flop*/, int /*bit*/) { return false; }
  // Of the values of all flops, and of all responses and all changes of output pins so far. Two runs of an engine with
  // equal digests and equal input pins go on equally. Only for engines with flops.
  [[nodiscard]] virtual std::uint64_t digest() { return 0; }

  // ---- registers: one access at a time, started at now()

  // Whether start() may be called: no access is under way, and the last response was popped.
  [[nodiscard]] virtual bool idle() const = 0;

  // Starts an access. Returns the cycle in which the processor will receive the response, if the engine knows it in
  // advance, else none. A client must not depend on it: advance() stops at that cycle in either case.
  virtual std::optional<Cycles> start(const BusRequest& request) = 0;

  // advance(at, StopOn::kAccess), start(), then advance(limit, StopOn::kPinChange): in one call, because a processor
  // that runs ahead does nothing else. No access is under way, and `at` is before quiet_until(). Where no other output
  // has changed an engine may go on after interrupts have fallen, which wakes no core.
  struct Progress {
    std::optional<BusResponse> response{};  // if the access has ended
    bool pins_changed = false;              // an output has changed at the end
    bool interrupts_fell = false;           // and it went on
    Cycles ends{};                          // now()
    Cycles quiet_until{};                   // quiet_until() if the access has ended
  };
  virtual Progress access(const BusRequest& request, Cycles at, Cycles limit);
  // access() of a register that nothing but the processor notices: no output and no edge that must be computed changes
  // by it, it ends before the horizon and without an error, and MotionPort::disturbs() is false. It begins at time.now
  // and moves that to its end, now(). `time.horizon`: not later than quiet_until(), and remains so. Returns the data of
  // a read, any data of a write; nothing, and does nothing, if the access may be another one.
  virtual std::optional<std::uint32_t> access_unnoticed(const BusRequest&, TimeAhead& /*time*/) { return std::nullopt; }
  // The rest of access(), after a change of an output has ended it.
  Progress continue_access(Cycles limit);

  // Whether a response waits for pop_response().
  [[nodiscard]] virtual bool has_response() const = 0;

  // Removes and returns the response. It is available from the cycle in which the processor receives it.
  virtual std::optional<BusResponse> pop_response() = 0;

  // An access that takes longer than this ends with BusError::kTimeout.
  [[nodiscard]] virtual Cycles access_timeout() const = 0;

  // ---- pins; an engine may compute the outputs only when outputs() is called

  // Levels for the coming clock edges, until the next call.
  virtual void set_inputs(const SocInputs& inputs) = 0;
  [[nodiscard]] virtual const SocOutputs& outputs() const = 0;

  // Interrupt levels, bit as in soc_map.toml: the same as outputs().irq, without computing the other pins.
  [[nodiscard]] virtual std::uint8_t interrupts() const = 0;

  // ---- whole ticks (motion_port.hpp); null: the engine computes every edge
  [[nodiscard]] virtual MotionPort* motion_port() { return nullptr; }

  // ---- waveforms: every signal of the engine into a file from now on, one file at a time. Both throw WaveError.
  virtual void add_to_waves(const SoftwareSignals&) {}  // as Fabric::add_to_waves
  virtual void open_wave(const std::filesystem::path& file, WaveFormat format) = 0;
  virtual void close_wave() = 0;
};

}  // namespace armature::cosim
