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
#include "cosim/iss/core_watcher.hpp"
#include "cosim/iss/instruction_time.hpp"
#include "cosim/iss/mpcore_model.hpp"
#include "cosim/iss/state_digest.hpp"

namespace armature::cosim::iss {

// A piece of the physical memory, which both cores see. `bytes` is a multiple of 4096, and so is `address`.
struct MemoryPiece {
  std::uint32_t address = 0;
  void* data = nullptr;
  std::size_t bytes = 0;
};

class ArmCore {
 public:
  // `charge`: the address of the function of the firmware whose calls are charged. `cpi`: clocks for each instruction,
  // in ARM state, counted by straight runs of code when they begin; none: instructions are neither charged nor counted.
  // `watcher`: hears of each instruction that is executed in simulated time, and must outlive the core; null: nobody
  // does, and no instruction takes longer. Throws std::runtime_error, as the others, when the engine fails.
  ArmCore(int number, std::uint32_t charge, std::optional<double> cpi = std::nullopt, CoreWatcher* watcher = nullptr);
  ArmCore(const ArmCore&) = delete;
  ArmCore& operator=(const ArmCore&) = delete;
  ~ArmCore();

  void map(const MemoryPiece& memory);

  // Executes from `start` up to `until`, before simulated time begins: it must access no register of the logic.
  void prepare(std::uint32_t start, std::uint32_t until);
  // Executes from `start` for ever, on the fiber of the core. Returns when wait_for_interrupt() returns kNone.
  void run(std::uint32_t start, CoreBus& bus);

  // A word of the memory has changed, which may be an instruction. From now on run() returns where the core cannot
  // continue, and time passes in a loop that calls nothing.
  void memory_has_flipped(std::uint32_t address);

  // Executed by run(), until the latest call of its bus; 0 if they are not counted.
  [[nodiscard]] std::int64_t instructions() const { return time_ ? time_->instructions() : 0; }

  // The program counter, with bit 0 set in Thumb state.
  [[nodiscard]] std::uint32_t pc() const;

  // ---- for a watcher, by the names of Unicorn (uc_arm_reg)
  // Simulated time begins here: before run() the registers show it.
  void set_start(std::uint32_t start) { write_register<std::uint32_t>(UC_ARM_REG_PC, start); }
  [[nodiscard]] int number() const { return number_; }
  // Registers and interrupts, for a core that waits().
  void add_to(StateDigest& digest) const;
  // Suspended in the WFI, behind which it continues, or before its start.
  [[nodiscard]] bool waits() const { return waits_; }
  // `Word`: of 32 bits, of the registers d0 to d31 of 64. Inside an access of the logic pc is not exact.
  template <class Word>
  [[nodiscard]] Word read_register(int name) const {
    Word value = 0;
    check(uc_reg_read(engine_, name, &value), "reads no register");
    return value;
  }
  // In before_instruction() of this core, or while it waits().
  template <class Word>
  void write_register(int name, Word value) {
    check(uc_reg_write(engine_, name, &value), "writes no register");
  }

 private:
  static std::uint64_t read_logic(uc_engine*, std::uint64_t offset, unsigned, void* self);
  static void write_logic(uc_engine*, std::uint64_t offset, unsigned, std::uint64_t value, void* self);
  static std::uint64_t read_mpcore(uc_engine*, std::uint64_t offset, unsigned, void* self);
  static void write_mpcore(uc_engine*, std::uint64_t offset, unsigned, std::uint64_t value, void* self);
  static void on_charge(uc_engine*, std::uint64_t address, std::uint32_t size, void* self);
  static void on_block(uc_engine*, std::uint64_t address, std::uint32_t bytes, void* self);
  static void on_watched(uc_engine*, std::uint64_t address, std::uint32_t size, void* self);
  static void on_data(uc_engine*, uc_mem_type type, std::uint64_t address, int size, std::int64_t value, void* self);

  void add_hook(uc_hook_type kind, void (*function)(uc_engine*, std::uint64_t, std::uint32_t, void*), void* data,
                std::uint32_t first, std::uint32_t last);
  void pass_time();

  void check(uc_err error, const char* what) const;

  int number_;
  uc_engine* engine_ = nullptr;
  MpcoreModel mpcore_;
  CoreBus* bus_ = nullptr;  // null: simulated time has not begun
  CoreWatcher* watcher_;
  bool waits_ = true;
  bool flipped_ = false;
  std::optional<InstructionTime> time_;
};

}  // namespace armature::cosim::iss
