// Switches the outputs of a plan at the ticks in which the pulses reach their places.
//
// The set-point of tick k is reached by the pulses of tick k + 1, at its end. An output is written at the start of a
// tick. So it is written at the start of tick k + 1 if its place is in the first half of the way of that tick,
// otherwise at the start of tick k + 2: at most half a tick from its place, and the few microseconds until the write.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/base/units.hpp"
#include "controller/message/event.hpp"
#include "controller/motion/set_point_source.hpp"
#include "controller/trajectory/plan/plan.hpp"

namespace armature {

class PathPins {
 public:
  // A plan begins; `plan` must not change until the next one begins or cancel().
  void begin() noexcept {
    next_ = 0;
    executed_ = 0.0;
  }
  // The plan is replaced by a window that continues it.
  void continue_with(const CartesianPlan& window) noexcept {
    next_ -= window.outputs_over;
    executed_ -= static_cast<double>(window.origin.value());
  }
  // Nothing more is written.
  void cancel() noexcept { next_tick_.count = tick_after_next_.count = 0; }

  // Call at the start of each tick: those of next() have been written. Reports them.
  void written(Ticks tick, EventListener& events) noexcept;
  // Call after the set-point of a tick: the plan has been executed up to `ticks`, or to its end.
  void advance(const Plan& plan, double ticks, bool ended) noexcept;
  // To be written at the start of the next tick.
  [[nodiscard]] PinLevels next() const noexcept;

 private:
  // In a tick the outputs of one plan come to the list, half a tick after those of the tick before.
  struct List {
    std::array<TimedOutput, 2 * TimedOutputs::kMax> outputs{};
    std::size_t count = 0;
  };

  std::size_t next_ = 0;                  // of the outputs of the plan
  double executed_ = 0.0;                 // ticks of the plan, up to the last set-point
  List next_tick_{}, tick_after_next_{};  // to be written at the start of the next tick and of the one after
};

}  // namespace armature
