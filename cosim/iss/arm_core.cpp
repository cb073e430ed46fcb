#include "cosim/iss/arm_core.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "controller/base/timebase.hpp"
#include "controller/board/mpcore.hpp"

namespace armature::cosim::iss {
namespace {

// M_AXI_GP0, as far as the logic has blocks.
constexpr std::uint32_t kLogicBase = 0x4000'0000;
constexpr std::uint32_t kLogicSize = 0x0400'0000;

constexpr std::uint32_t kInstructionBytes = 4;  // in ARM state, which the firmware never leaves
constexpr std::uint32_t kLastAddress = 0xFFFF'FFFF;
constexpr std::uint64_t kNowhere = 0xFFFF'FFFE;  // no instruction is there
constexpr std::uint32_t kThumbState = 1u << 5;   // of CPSR

// Of the word: after a flip an address may have any value.
RegAddr register_at(std::uint64_t offset) {
  return {kLogicBase + static_cast<std::uint32_t>(offset & ~std::uint64_t{3})};
}

ArmCore& core(void* self) {
  return *static_cast<ArmCore*>(self);
}

}  // namespace

ArmCore::ArmCore(int number, std::uint32_t charge, std::optional<double> cpi, CoreWatcher* watcher)
    : number_{number}, watcher_{watcher} {
  check(uc_open(UC_ARCH_ARM, UC_MODE_ARM, &engine_), "opens no engine");
  check(uc_ctl_set_cpu_model(engine_, UC_CPU_ARM_CORTEX_A9), "has no Cortex-A9");
  check(uc_mmio_map(engine_, kLogicBase, kLogicSize, read_logic, this, write_logic, this), "maps no logic");
  check(uc_mmio_map(engine_, board::mpcore::kBase, board::mpcore::kSize, read_mpcore, this, write_mpcore, this),
        "maps no MPCore");
  // Before the first translation, because the engine adds the calls when it translates. What hears of an instruction
  // first finds it neither counted nor charged.
  if (watcher != nullptr) {
    add_hook(UC_HOOK_CODE, on_watched, this, 0, kLastAddress);
    uc_hook hook = 0;
    void* const data = reinterpret_cast<void*>(on_data);  // NOLINT: Unicorn takes any function so
    check(uc_hook_add(engine_, &hook, UC_HOOK_MEM_READ | UC_HOOK_MEM_WRITE, data, this, 1, 0), "adds no hook");
  }
  // A call for each instruction would take three times as long.
  if (cpi) {
    time_.emplace(*cpi);
    add_hook(UC_HOOK_BLOCK, on_block, this, 0, kLastAddress);
  }
  add_hook(UC_HOOK_CODE, on_charge, this, charge, charge);
}

void ArmCore::add_hook(uc_hook_type kind, void (*function)(uc_engine*, std::uint64_t, std::uint32_t, void*), void* data,
                       std::uint32_t first, std::uint32_t last) {
  uc_hook hook = 0;
  void* const any = reinterpret_cast<void*>(function);  // NOLINT: Unicorn takes any function so
  check(uc_hook_add(engine_, &hook, kind, any, data, first, last), "adds no hook");
}

ArmCore::~ArmCore() {
  if (engine_ != nullptr) uc_close(engine_);
}

void ArmCore::map(const MemoryPiece& memory) {
  check(uc_mem_map_ptr(engine_, memory.address, memory.bytes, UC_PROT_ALL, memory.data), "maps no memory");
}

void ArmCore::prepare(std::uint32_t start, std::uint32_t until) {
  check(uc_emu_start(engine_, start, until, 0, 0), "does not start");
  if (pc() != until) throw std::runtime_error{fmt::format("core {} does not start: it waits at {:#x}", number_, pc())};
}

void ArmCore::run(std::uint32_t start, CoreBus& bus) {
  bus_ = &bus;
  waits_ = false;
  if (time_) time_->reset();
  for (std::uint32_t next = start;; next = pc()) {
    const uc_err error = uc_emu_start(engine_, next, kNowhere, 0, 0);
    pass_time();
    if (flipped_ && error != UC_ERR_OK) return;
    check(error, "fails");
    waits_ = true;
    const Interrupts lines = bus.wait_for_interrupt(mpcore_.enabled());
    waits_ = false;
    if (lines == Interrupts::kNone) return;
    mpcore_.set_pending(lines);
  }
}

void ArmCore::memory_has_flipped(std::uint32_t address) {
  flipped_ = true;
  check(uc_ctl_remove_cache(engine_, address, address + kInstructionBytes), "forgets no code");
}

void ArmCore::add_to(StateDigest& digest) const {
  constexpr int kGeneral = 13;
  for (int i = 0; i < kGeneral; ++i) digest.add(read_register<std::uint32_t>(UC_ARM_REG_R0 + i));
  for (const int name : {UC_ARM_REG_SP, UC_ARM_REG_LR, UC_ARM_REG_PC, UC_ARM_REG_CPSR, UC_ARM_REG_FPSCR}) {
    digest.add(read_register<std::uint32_t>(name));
  }
  for (int name = UC_ARM_REG_D0; name <= UC_ARM_REG_D31; ++name) digest.add(read_register<std::uint64_t>(name));
  digest.add(mpcore_.digest());
  if (time_) digest.add(static_cast<std::uint64_t>(time_->rest()));
}

std::uint32_t ArmCore::pc() const {
  return read_register<std::uint32_t>(UC_ARM_REG_PC) |
         ((read_register<std::uint32_t>(UC_ARM_REG_CPSR) & kThumbState) != 0 ? 1u : 0u);
}

void ArmCore::check(uc_err error, const char* what) const {
  if (error == UC_ERR_OK) return;
  std::uint32_t pc = 0;
  const bool known = engine_ != nullptr && uc_reg_read(engine_, UC_ARM_REG_PC, &pc) == UC_ERR_OK;
  const std::string at = known ? fmt::format(" at {:#x}", pc) : std::string{};
  throw std::runtime_error{fmt::format("the simulator of ARM core {} {}{}: {}", number_, what, at, uc_strerror(error))};
}

// What was executed takes its time before anything else happens.
void ArmCore::pass_time() {
  if (time_ && bus_ != nullptr) bus_->pass(time_->take());
}

void ArmCore::on_block(uc_engine*, std::uint64_t, std::uint32_t bytes, void* self) {
  ArmCore& one = core(self);
  one.time_->count(bytes / kInstructionBytes);
  if (one.flipped_ && one.time_->due() >= armature::kTickCycles) one.pass_time();
}

void ArmCore::on_watched(uc_engine*, std::uint64_t address, std::uint32_t, void* self) {
  ArmCore& one = core(self);
  if (one.bus_ != nullptr) one.watcher_->before_instruction(one, static_cast<std::uint32_t>(address));
}

void ArmCore::on_data(uc_engine*, uc_mem_type type, std::uint64_t address, int size, std::int64_t, void* self) {
  ArmCore& one = core(self);
  if (one.bus_ == nullptr) return;
  one.watcher_->on_data(one, {.address = static_cast<std::uint32_t>(address),
                              .bytes = static_cast<std::uint32_t>(size),
                              .write = type == UC_MEM_WRITE});
}

std::uint64_t ArmCore::read_logic(uc_engine*, std::uint64_t offset, unsigned, void* self) {
  core(self).pass_time();
  return core(self).bus_->read32(register_at(offset));
}

void ArmCore::write_logic(uc_engine*, std::uint64_t offset, unsigned, std::uint64_t value, void* self) {
  core(self).pass_time();
  core(self).bus_->write32(register_at(offset), static_cast<std::uint32_t>(value));
}

std::uint64_t ArmCore::read_mpcore(uc_engine*, std::uint64_t offset, unsigned, void* self) {
  core(self).pass_time();
  return core(self).mpcore_.read(static_cast<std::uint32_t>(offset), core(self).bus_);
}

void ArmCore::write_mpcore(uc_engine*, std::uint64_t offset, unsigned, std::uint64_t value, void* self) {
  core(self).pass_time();
  core(self).mpcore_.write(static_cast<std::uint32_t>(offset), static_cast<std::uint32_t>(value), core(self).bus_);
}

void ArmCore::on_charge(uc_engine*, std::uint64_t, std::uint32_t, void* self) {
  ArmCore& one = core(self);
  if (one.bus_ == nullptr) return;
  one.pass_time();
  const auto work = one.read_register<std::uint32_t>(UC_ARM_REG_R0);
  if (one.flipped_ && work >= kWorks) return;
  one.bus_->charge(static_cast<Work>(work), one.read_register<std::uint32_t>(UC_ARM_REG_R1));
}

}  // namespace armature::cosim::iss
