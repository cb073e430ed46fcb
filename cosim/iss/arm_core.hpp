// One Cortex-A9 that executes instructions: a Unicorn engine in the fiber of a simulated core.
//
// It runs until it waits for an interrupt (WFI), accesses a register of the logic, or charges work. There it calls the
// CoreBus of its core, which suspends the fiber inside the engine and continues it when simulated time has passed. The
// engine takes no simulated time by itself, unless its instructions are charged. Then their time passes before each of
// these calls.
#pragma once

#include <unicorn/unicorn.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "cosim/cpu/core_bus.hpp"
#include "cosim/iss/instruction_time.hpp"
#include "cosim/iss/mpcore_model.hpp"

namespace armature::cosim::iss {

// A piece of the physical memory, which both cores see. `bytes` is a multiple of 4096, and so is `address`.
struct MemoryPiece {
  std::uint32_t address = 0;
  void* data = nullptr;
  std::size_t bytes = 0;
};

class ArmCore {
 public:
  // `charge`: the address of the function of the firmware whose calls are charged. `cpi`: clocks for each instruction;
  // none: instructions are neither charged nor counted. Throws std::runtime_error, as the others, when the engine
  // fails.
  ArmCore(int number, std::uint32_t charge, std::optional<double> cpi = std::nullopt);
  ArmCore(const ArmCore&) = delete;
  ArmCore& operator=(const ArmCore&) = delete;
  ~ArmCore();

  void map(const MemoryPiece& memory);

  // Executes from `start` up to `until`, before simulated time begins: it must access no register of the logic.
  void prepare(std::uint32_t start, std::uint32_t until);
  // Executes from `start` for ever, on the fiber of the core. Returns when wait_for_interrupt() returns kNone.
  void run(std::uint32_t start, CoreBus& bus);

  // Executed by run(), until the latest call of its bus; 0 if they are not counted.
  [[nodiscard]] std::int64_t instructions() const { return time_ ? time_->instructions() : 0; }

  // The program counter, with bit 0 set in Thumb state.
  [[nodiscard]] std::uint32_t pc() const;

 private:
  static std::uint64_t read_logic(uc_engine*, std::uint64_t offset, unsigned, void* self);
  static void write_logic(uc_engine*, std::uint64_t offset, unsigned, std::uint64_t value, void* self);
  static std::uint64_t read_mpcore(uc_engine*, std::uint64_t offset, unsigned, void* self);
  static void write_mpcore(uc_engine*, std::uint64_t offset, unsigned, std::uint64_t value, void* self);
  static void on_charge(uc_engine*, std::uint64_t address, std::uint32_t size, void* self);
  static void on_instruction(uc_engine*, std::uint64_t address, std::uint32_t size, void* time);

  void add_hook(void (*function)(uc_engine*, std::uint64_t, std::uint32_t, void*), void* data, std::uint32_t first,
                std::uint32_t last);
  void pass_time();

  void check(uc_err error, const char* what) const;
  [[nodiscard]] std::uint32_t read_register(int name) const;

  int number_;
  uc_engine* engine_ = nullptr;
  MpcoreModel mpcore_;
  CoreBus* bus_ = nullptr;  // null: simulated time has not begun
  std::optional<InstructionTime> time_;
};

}  // namespace armature::cosim::iss
