// Model of the block policy_mlp: registers, memory, time and interrupt; network_run computes its outputs. From
// rtl/REGISTERS.md and rtl/policy_mlp/README.md.
//
//   edge   n                n + 1    n + 1 + CYCLES      n + 2 + CYCLES   n + 3 + CYCLES
//          write of start   start    end, STATUS.done    EVENT.ended      irq()
//
// Must be computed: accesses, the edges above, and an edge after a change of what the interrupt depends on.
#pragma once

#include <cstddef>
#include <cstdint>

#include "controller/regs/policy_mlp_regs.hpp"
#include "cosim/model/block.hpp"
#include "cosim/model/policy_mlp/network_run.hpp"

namespace armature::cosim::model {

// It has no pins but its bus.
struct PolicyInputs {
  bool operator==(const PolicyInputs&) const = default;
};

class PolicyMlp {
 public:
  static constexpr std::size_t kLanes = regs::policy_mlp::kIdLanesReset;

  Answer edge(Cycles at, const Strobes& access, const PolicyInputs& inputs);
  Answer access(Cycles at, const Strobes& access, const PolicyInputs& inputs) { return edge(at, access, inputs); }
  [[nodiscard]] Cycles wakes_at() const { return wakes_at_; }

  [[nodiscard]] bool irq() const { return irq_; }

 private:
  [[nodiscard]] bool interrupts() const { return event_ && irq_enabled_; }
  [[nodiscard]] Answer read(Cycles at, std::uint32_t offset) const;
  [[nodiscard]] std::uint32_t status() const;
  [[nodiscard]] std::uint32_t outputs(std::size_t first) const;
  // Returns whether the word cannot be written. `busy`: before the edge.
  [[nodiscard]] bool write(const Strobes& access, bool busy);
  void write_control(const Strobes& access);
  void store(const Strobes& access, bool busy);
  void end_run();

  mlp::Memory memory_{};
  std::array<std::uint32_t, regs::policy_mlp::kInputCount> inputs_{};
  std::uint32_t address_ = 0, bound_ = 0, crc_ = 0;
  bool irq_enabled_ = false, start_ = false, event_ = false, irq_ = false;

  // The present run, or the last one.
  bool busy_ = false;
  Cycles started_{}, ends_{};
  mlp::Outcome run_;
  bool done_ = false, refused_ = false, corrupt_ = false, malformed_ = false, ended_ = false;  // ended_: latest edge
  Cycles wakes_at_ = kNever;
};

}  // namespace armature::cosim::model
