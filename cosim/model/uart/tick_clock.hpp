// The ticks of a baud rate: one every `divisor` edges from a restart on, 16 per bit. Ticks at which nothing happens are
// passed at once.
#pragma once

#include <cstdint>

#include "cosim/model/block.hpp"

namespace armature::cosim::model {

class TickClock {
 public:
  // The next tick comes `divisor` edges after the edge `at`; none comes if it is 0.
  void restart(Cycles at, std::int64_t divisor) { next_ = divisor == 0 ? kNever : at + Cycles{divisor}; }

  // Counts the ticks before the edge `at` that were not seen yet.
  [[nodiscard]] std::int64_t pass(Cycles at, std::int64_t divisor) {
    if (next_ >= at || divisor == 0) return 0;
    const std::int64_t ticks = (at - next_).value() / divisor + ((at - next_).value() % divisor != 0 ? 1 : 0);
    next_ += Cycles{ticks * divisor};
    return ticks;
  }
  // Whether the edge `at` has a tick; it counts as seen.
  [[nodiscard]] bool tick(Cycles at, std::int64_t divisor) {
    if (next_ != at || divisor == 0) return false;
    next_ += Cycles{divisor};
    return true;
  }
  // The edge of the tick after `ticks` more; kNever while the divisor is 0.
  [[nodiscard]] Cycles after(std::int64_t ticks, std::int64_t divisor) const {
    return divisor == 0 ? kNever : next_ + Cycles{ticks * divisor};
  }

 private:
  Cycles next_{};
};

}  // namespace armature::cosim::model
