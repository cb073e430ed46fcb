// A processor that runs the controller as compiled for the host: each core is a fiber.
#pragma once

#include <array>
#include <deque>

#include "controller/app/controller.hpp"
#include "controller/host_memory/memory.hpp"
#include "cosim/cpu/core.hpp"
#include "cosim/cpu/cpu_spec.hpp"
#include "cosim/cpu/processor.hpp"

namespace armature::cosim {

class FiberProcessor final : public Processor {
 public:
  FiberProcessor(host_memory::HostMemory& memory, const CpuSpec& spec);

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
  Cycles worst_tick(Cycles now) const override { return cores_[0].longest_awake(now); }
  void reset_worst_tick() override { cores_[0].reset_longest_awake(); }
  Cycles awake(int core, Cycles now) const override { return cores_.at(static_cast<std::size_t>(core)).awake(now); }

 private:
  void exchange_events(Cycles now);

  Controller controller_;
  std::deque<Access> stray_;   // not finished
  std::array<Core, 2> cores_;  // last member: their mains use all of the above
};

}  // namespace armature::cosim
