// The pulse generator of one axis in the paper's variant: step changes every |WIDTH| edges (Vo 2021, Figure 6;
// rtl/pulse_width/README.md). Each trigger outside a stop restarts it: step low, the direction of the sign, the first
// rising edge |WIDTH| edges later.
#pragma once

#include <cstdint>

#include "cosim/model/block.hpp"

namespace armature::cosim::model {

class WidthAxis {
 public:
  // The edge `at`. `stop`: no pulse may rise. `width`: half period, in edges, signed; acts with the trigger.
  void edge(Cycles at, bool trigger, bool stop, std::uint32_t width) {
    if (trigger && !stop) {
      start(at, width);
    } else if (at == toggle_at_) {
      toggle(at, stop);
    }
    if (stop) running_ = false;
  }

  [[nodiscard]] Cycles wakes_at() const { return running_ || step_ ? toggle_at_ : kNever; }

  [[nodiscard]] bool step() const { return step_; }
  [[nodiscard]] bool positive() const { return positive_; }
  [[nodiscard]] std::uint32_t emitted() const { return emitted_; }  // rising edges, signed by direction
  [[nodiscard]] bool is_running() const { return running_; }

 private:
  void start(Cycles at, std::uint32_t width) {
    const bool negative = width >> 31 != 0;
    step_ = false;
    running_ = width != 0;
    if (running_) positive_ = !negative;
    width_ = Cycles{negative ? 0u - width : width};
    toggle_at_ = running_ ? at + width_ : kNever;
  }

  void toggle(Cycles at, bool stop) {
    const bool rises = !step_ && running_ && !stop;
    if (rises) emitted_ += positive_ ? 1u : ~0u;
    step_ = rises;
    toggle_at_ = at + width_;
  }

  bool step_ = false, positive_ = false, running_ = false;
  std::uint32_t emitted_ = 0;
  Cycles width_{};
  Cycles toggle_at_ = kNever;
};

}  // namespace armature::cosim::model
