// Model of the block ik_cordic: registers, time and interrupt; ik_solver computes its angles. From rtl/REGISTERS.md and
// rtl/ik_cordic/README.md.
//
//   edge   n                n + 1    n + 2 .. n + 23   n + 1 + CYCLES      n + 2 + CYCLES   n + 3 + CYCLES
//          write of start   start    inputs copied     end, STATUS.done    EVENT.done       irq()
//
// Must be computed: accesses, the edges above, and an edge after a change of what the interrupt depends on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/regs/ik_cordic_regs.hpp"
#include "cosim/model/block.hpp"
#include "cosim/model/ik_cordic/ik_solver.hpp"

namespace armature::cosim::model {

// It has no pins but its bus.
struct IkInputs {
  bool operator==(const IkInputs&) const = default;
};

class IkCordic {
 public:
  Answer edge(Cycles at, const Strobes& access, const IkInputs& inputs);
  Answer access(Cycles at, const Strobes& access, const IkInputs& inputs) { return edge(at, access, inputs); }
  [[nodiscard]] Cycles wakes_at() const { return wakes_at_; }

  [[nodiscard]] bool irq() const { return irq_; }

 private:
  // The registers that a start copies, in the order in which it does: one per edge.
  static constexpr std::size_t kInputs = 22;
  using Words = std::array<std::uint32_t, kInputs>;

  [[nodiscard]] bool is_busy() const { return state_ != State::kIdle; }
  [[nodiscard]] bool interrupts() const { return done_event_ && irq_enabled_; }
  [[nodiscard]] Answer read(Cycles at, std::uint32_t offset) const;
  [[nodiscard]] std::uint32_t flags() const;
  // Returns whether the word cannot be written.
  [[nodiscard]] bool write(Cycles at, const Strobes& access);
  void continue_run(Cycles at);

  Words words_{};
  bool five_r_ = false, irq_enabled_ = false, start_ = false, done_event_ = false, irq_ = false;

  // The present run, or the last one.
  enum class State : std::uint8_t { kIdle, kCopies, kSolves } state_ = State::kIdle;
  Cycles started_{};  // the edge of the start; word i is copied at started_ + 1 + i
  Words copied_{};
  bool copied_five_r_ = false;
  Cycles ends_{};
  ik::Solved solved_ = ik::unsolved();
  bool done_ = false, refused_ = false, ended_ = false;  // ended_: at the latest edge
  Cycles wakes_at_ = kNever;
};

}  // namespace armature::cosim::model
