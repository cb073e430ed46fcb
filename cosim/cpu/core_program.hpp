// The program that the two cores of a CoreProcessor run.
#pragma once

#include <cstdint>
#include <optional>

#include "cosim/cpu/core_bus.hpp"
#include "cosim/cpu/core_memory.hpp"

namespace armature::cosim {

class CoreProgram {
 public:
  virtual ~CoreProgram() = default;
  // The main of core 0 or 1, on the stack of its fiber. When it returns, the core does nothing more. The fiber may be
  // abandoned in any call of `bus`, so objects on the stack must own nothing.
  virtual void main(int core, CoreBus& bus) = 0;
  // Whether core 0 may run ahead (run_ahead.hpp). If not, both cores execute in the order of simulated time.
  [[nodiscard]] virtual bool may_run_ahead() const { return true; }
  // As of Processor.
  [[nodiscard]] virtual const CoreMemory& memory() const {
    static const CoreMemory kNone;
    return kNone;
  }
  virtual void flip_memory(std::uint32_t /*addr*/, std::uint32_t /*mask*/) {}
  // Of registers and memory() while both cores wait for an interrupt. None: they do not, or have no memory of their
  // own.
  [[nodiscard]] virtual std::optional<std::uint64_t> digest() const { return std::nullopt; }
  // What a core has executed until its latest call of its bus; 0 of a program that does not count.
  [[nodiscard]] virtual std::int64_t instructions(int /*core*/) const { return 0; }
};

}  // namespace armature::cosim
