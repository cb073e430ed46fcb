// A processor of two cores, each of which is a fiber, that run the two mains of a program.
#pragma once

#include <array>
#include <deque>
#include <memory>

#include "cosim/cpu/core.hpp"
#include "cosim/cpu/core_program.hpp"
#include "cosim/cpu/cpu_spec.hpp"
#include "cosim/cpu/processor.hpp"

namespace armature::cosim {

class CoreProcessor final : public Processor {
 public:
  CoreProcessor(std::unique_ptr<CoreProgram> program, const CpuSpec& spec);

  // Processor
  void run_ahead(RunAhead& simulation) override;
  void notify(Cycles now) override;
  std::optional<Cycles> next_event() const override;
  void advance(Cycles now) override;
  std::optional<Access> next_access() const override;
  void complete(const Access& access, const BusResponse& response, Cycles now) override;
  void abort(const Access& access, Cycles now) override;
  CoreState core_state(int core) const override { return cores_.at(static_cast<std::size_t>(core)).state(); }
  void set_interrupts(std::uint8_t levels, Cycles now) override;
  void set_tick_compute(Cycles cost) override { cores_[0].set_tick_compute(cost.value()); }
  void write_astray(std::uint32_t addr, std::uint32_t data) override;
  void flip_astray(std::uint32_t addr, std::uint32_t mask) override;
  const CoreMemory& memory() const override { return program_->memory(); }
  void flip_memory(std::uint32_t addr, std::uint32_t mask) override { program_->flip_memory(addr, mask); }
  std::optional<std::uint64_t> digest() const override;
  void stop_core_one(Cycles now) override;
  Cycles worst_tick(Cycles now) const override { return cores_[0].longest_awake(now); }
  void reset_worst_tick() override { cores_[0].reset_longest_awake(); }
  std::int64_t instructions(int core) const override { return program_->instructions(core); }
  Cycles awake(int core, Cycles now) const override { return cores_.at(static_cast<std::size_t>(core)).awake(now); }

 private:
  void exchange_events(Cycles now);

  std::unique_ptr<CoreProgram> program_;
  std::deque<Access> stray_;   // not finished
  std::array<Core, 2> cores_;  // last member: their mains use all of the above
};

}  // namespace armature::cosim
