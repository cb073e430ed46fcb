// What stops all pulses: the emergency-stop pin and register, and the watchdog; and the heartbeat (rtl/pulse_train/
// README.md, "Stops", "Watchdog", "Heartbeat").
//
// The watchdog has two causes. WATCHDOG.limit underruns in a row, and WATCHDOG.limit + 1 own ticks of TICK_CYCLES edges
// without a set that became active.
#pragma once

#include <algorithm>
#include <cstdint>

#include "cosim/model/block.hpp"

namespace armature::cosim::model {

class StopControl {
 public:
  // Before an edge.
  struct Inputs {
    bool pin_low = false;  // behind the synchroniser
    bool stop = false;     // the register was written, likewise the clears
    bool clear_estop = false;
    bool clear_watchdog = false;
    bool trigger = false;
    bool run = false;      // CTRL.run
    bool pending = false;  // a committed set waits
    std::uint32_t limit = 4;
    Cycles tick{2500};
  };
  struct Events {
    bool estop = false;
    bool watchdog = false;
    bool underrun = false;
    bool set_begins = false;
  };

  // Whether no pulse may rise, and no set may begin, at the coming edge.
  [[nodiscard]] bool stops(const Inputs& in) const { return in.pin_low || in.stop || estop_ || watchdog_; }

  Events edge(Cycles at, const Inputs& in) {
    leave_out(at - Cycles{1}, in.tick);
    const bool stopped = stops(in);
    const bool counts = in.run && !stopped;
    Events events;
    events.estop = in.stop || (in.pin_low && !pin_was_low_);
    events.set_begins = in.trigger && !stopped && in.pending;
    events.underrun = in.trigger && !stopped && in.run && !in.pending;
    const bool late = own_tick_ && counts && !events.set_begins && idle_ticks_ != 0 && idle_ticks_ >= in.limit;
    events.watchdog = late || (events.underrun && in_a_row_ + 1 >= in.limit);
    pin_was_low_ = in.pin_low;

    estop_ = in.pin_low || in.stop || (estop_ && !in.clear_estop);
    watchdog_ = events.watchdog || (watchdog_ && !(in.clear_watchdog && !in.pin_low));
    if (stopped || (in.trigger && !events.underrun)) {
      in_a_row_ = 0;
    } else if (events.underrun) {
      ++in_a_row_;
      underruns_ += underruns_ != ~0u;
    }
    count_own_ticks(at, counts, events.set_begins, in.tick);
    heartbeat_ = heartbeat_ != events.set_begins;
    return events;
  }

  // Edges up to `at`, before wakes_at(), were not computed. Call it before TICK_CYCLES, which was `tick`, changes.
  void leave_out(Cycles at, Cycles tick) {
    if (!counting_ || at < own_end_at_) return;
    own_tick_ = true;
    own_end_at_ += length(tick);
  }

  // The next edge that must be computed. `in`: what the coming edge will see.
  [[nodiscard]] Cycles wakes_at(Cycles at, const Inputs& in) const {
    const bool stopped = stops(in);
    const bool due = in.trigger || own_tick_ || (in.run && !stopped) != counting_ || in.pin_low != pin_was_low_ ||
                     (stopped && in_a_row_ != 0) || in.stop || in.clear_estop || in.clear_watchdog;
    return due ? at + Cycles{1} : counting_ ? own_end_at_ + Cycles{1} : kNever;
  }

  // Whether nothing stops pulses up to the next trigger if neither pins nor registers change.
  [[nodiscard]] bool is_calm(const Inputs& in) const {
    return !stops(in) && (!counting_ || idle_ticks_ == 0 || idle_ticks_ + 1 < in.limit);
  }

  [[nodiscard]] bool estop() const { return estop_; }
  [[nodiscard]] bool watchdog() const { return watchdog_; }
  [[nodiscard]] bool heartbeat() const { return heartbeat_; }
  [[nodiscard]] std::uint32_t in_a_row() const { return in_a_row_; }
  [[nodiscard]] std::uint32_t idle_ticks() const { return idle_ticks_; }
  [[nodiscard]] std::uint32_t underruns() const { return underruns_; }

 private:
  [[nodiscard]] static Cycles length(Cycles tick) { return std::max(tick, Cycles{2}); }

  // An own tick begins when counting begins, and with each set. It ends after TICK_CYCLES edges, and takes effect one
  // edge later.
  void count_own_ticks(Cycles at, bool counts, bool set_begins, Cycles tick) {
    if (!counts) {
      counting_ = own_tick_ = false;
      idle_ticks_ = 0;
    } else if (!counting_ || set_begins) {
      counting_ = true;
      own_end_at_ = at + length(tick) - Cycles{1};
      own_tick_ = false;
      idle_ticks_ = 0;
    } else {
      idle_ticks_ = (idle_ticks_ + own_tick_) & 0xFF;
      own_tick_ = at == own_end_at_;
      if (own_tick_) own_end_at_ += length(tick);
    }
  }

  bool pin_was_low_ = false;
  bool estop_ = false, watchdog_ = false;
  bool heartbeat_ = false;
  std::uint32_t in_a_row_ = 0, underruns_ = 0;
  bool counting_ = false;
  bool own_tick_ = false;  // an own tick has just ended
  std::uint32_t idle_ticks_ = 0;
  Cycles own_end_at_{};
};

}  // namespace armature::cosim::model
