// The processing system with its two cores: runs the controller in simulated time.
//
// The controller and its host share only one memory (controller/host_memory/memory.hpp) and interrupt lines. Neither
// side calls the other. So a processor may run the controller as compiled for the host (HostProgram) or execute the
// instructions of its cross-compiled program. A core takes simulated time for its computations and for each access to a
// register. It runs only inside the functions below that have a parameter `now`. Each of them returns when all cores
// wait.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/base/units.hpp"
#include "cosim/bus/bus_access.hpp"
#include "cosim/cpu/core_memory.hpp"
#include "cosim/cpu/run_ahead.hpp"

namespace armature::cosim {

enum class CoreState : std::uint8_t {
  kWaiting,    // for an interrupt
  kComputing,  // time passes
  kBus,        // for an access, or for the bus
  kHalted,     // for good, after abort()
};

class Processor {
 public:
  // An access to a register that a core waits for, or a write of write_astray().
  struct Access {
    int core = 0;
    BusRequest request;
    bool stray = false;
    std::uint32_t flips = 0;  // of a stray read: it is written back with these bits inverted
  };

  virtual ~Processor() = default;

  // From now on core 0 may run ahead of `simulation`, which must outlive the processor. A processor need not do it.
  // After each call below that has `now` the chip may be at a later cycle, and an access of core 0 may be under way.
  virtual void run_ahead(RunAhead& simulation) = 0;

  // Wakes core 1 after the host has written commands into the host memory. The host must read the rings of events there
  // after each of the calls below.
  virtual void notify(Cycles now) = 0;

  // The next cycle at which a core continues by itself, if there is one.
  [[nodiscard]] virtual std::optional<Cycles> next_event() const = 0;
  // Continues the cores that are due.
  virtual void advance(Cycles now) = 0;

  // The access to start next: a stray write, or the one of core 0, which has the deadline, or of core 1. The core waits
  // until complete() of this access.
  [[nodiscard]] virtual std::optional<Access> next_access() const = 0;
  virtual void complete(const Access& access, const BusResponse& response, Cycles now) = 0;
  // Instead of complete(): the access ended with an error response, an external abort of its core. The core stops for
  // good.
  virtual void abort(const Access& access, Cycles now) = 0;

  // What a core, 0 or 1, does until the next call that has `now`.
  [[nodiscard]] virtual CoreState core_state(int core) const = 0;

  // Levels of the interrupt lines of the chip, bit as in soc_map.toml.
  virtual void set_interrupts(std::uint8_t levels, Cycles now) = 0;

  // Sets the time that core 0 needs for the computation of a tick from now on (fault script).
  virtual void set_tick_compute(Cycles cost) = 0;

  // Core 1 writes a word that no line of its program means to write (fault script). Its program does not wait for it.
  virtual void write_astray(std::uint32_t addr, std::uint32_t data) = 0;

  // The same with the word of this register, in which the bits of `mask` are inverted.
  virtual void flip_astray(std::uint32_t addr, std::uint32_t mask) = 0;

  // The memory of the cores that flip_memory() can change.
  [[nodiscard]] virtual const CoreMemory& memory() const = 0;
  // Inverts the bits of `mask` in a word of it (fault script). From then on a core that cannot continue stops for good.
  virtual void flip_memory(std::uint32_t addr, std::uint32_t mask) = 0;

  // Of the state of cores that have a memory: two of them with equal digests go on equally. None: it is not known now.
  [[nodiscard]] virtual std::optional<std::uint64_t> digest() const = 0;

  // Core 1 stops for good (fault script).
  virtual void stop_core_one(Cycles now) = 0;

  // The longest time for which core 0 was awake until `now`: the duration of the worst tick.
  [[nodiscard]] virtual Cycles worst_tick(Cycles now) const = 0;
  virtual void reset_worst_tick() = 0;

  // The time until `now` in which a core computed or waited for the bus.
  [[nodiscard]] virtual Cycles awake(int core, Cycles now) const = 0;

  // The instructions that a core has executed; 0 of a processor that does not count them.
  [[nodiscard]] virtual std::int64_t instructions(int core) const = 0;
};

}  // namespace armature::cosim
