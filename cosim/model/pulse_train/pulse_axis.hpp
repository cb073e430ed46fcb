// The pulse generator of one axis: spreads the signed count of a tick over its clocks (rtl/pulse_train/README.md).
//
// A tick begins at the edge that sees the trigger. From the first edge at which the axis is free, step changes at the
// edges ceil(k W / 2n), k = 1 .. 2n, of the window W: TICK_CYCLES without the edges at which the axis was blocked. The
// axis is blocked while a pulse of the tick before is high, and by a reversal: DIR_HOLD edges from the last falling
// edge to the change of direction, DIR_SETUP edges after it. A level lasts kMinWidth edges at least; a change that
// waits for it delays all later ones. No pulse rises at the edge of a trigger or under a stop.
#pragma once

#include <cstdint>
#include <optional>

#include "cosim/logic/whole_tick.hpp"
#include "cosim/model/block.hpp"

namespace armature::cosim::model {

class PulseAxis {
 public:
  static constexpr Cycles kMinWidth{6};

  // Registers, as they are before the edge.
  struct Times {
    Cycles tick{2500};
    Cycles dir_setup{25};
    Cycles dir_hold{25};
  };

  // The edge `at`. `stop`: no pulse may rise.
  void edge(Cycles at, const Times& times, bool trigger, bool stop);
  // After edge() with the trigger: the tick that begins at this edge has `count` pulses; with `stop` none.
  void begin_tick(Cycles at, const Times& times, std::int32_t count, bool stop);

  // The next edge at which a level changes, if no trigger and no stop come first.
  [[nodiscard]] Cycles wakes_at(const Times& times) const;

  // ---- whole ticks

  // The pulses of the tick that has begun at the latest edge, if no stop comes; none: only its edges say them.
  [[nodiscard]] std::optional<AxisPulses> whole_tick(const Times& times) const;
  // To the last edge before the end of that tick, whose edges were left out.
  void finish_tick(const AxisPulses& pulses);

  // The edge of the latest change of step, and of the latest change of the direction (0 before the first one).
  [[nodiscard]] Cycles changed_at() const { return changed_at_; }
  [[nodiscard]] Cycles turned_at(const Times& times) const { return set_up_at_ - times.dir_setup - Cycles{1}; }

  [[nodiscard]] bool step() const { return step_; }
  [[nodiscard]] bool positive() const { return positive_; }
  [[nodiscard]] std::uint32_t emitted() const { return emitted_; }       // rising edges, signed by direction
  [[nodiscard]] std::int32_t unfinished() const { return unfinished_; }  // of the running tick
  [[nodiscard]] bool is_running() const { return running_; }

 private:
  [[nodiscard]] bool turns() const { return positive_ != (unfinished_ >= 0); }
  [[nodiscard]] bool spreads(Cycles at) const { return step_ ? own_pulse_ : at >= set_up_at_ && !turns(); }
  void end_pulse_before(Cycles at);
  void turn(Cycles at, const Times& times);
  void start_window(Cycles at);
  void toggle(Cycles at);
  [[nodiscard]] Cycles turn_at(const Times& times) const;

  bool step_ = false;
  bool positive_ = false;
  bool running_ = false;    // edges of this tick are left
  bool own_pulse_ = false;  // the high pulse belongs to the running tick
  bool window_open_ = false;
  std::int32_t unfinished_ = 0;
  std::uint32_t emitted_ = 0;
  std::int64_t increment_ = 0;  // 2 n
  std::int64_t window_ = 0;     // W; while the window is not open: of a tick that is not blocked
  std::int64_t gained_ = 0;     // at toggle_at_ the sum of increments is W + this
  Cycles began_at_{};           // edge of the trigger
  Cycles toggle_at_{};          // the next change of step, without a delay by the minimum width
  Cycles changed_at_{1};        // edge of the latest change of step
  Cycles set_up_at_{};          // first edge after the set-up time of the direction
};

}  // namespace armature::cosim::model
