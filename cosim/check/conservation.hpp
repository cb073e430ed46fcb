// The conservation invariant: no pulse and no count appears or disappears between the software and the motors.
//
// Checked in every run, every tick, every axis:
//   committed by the software = rising edges on the step pins      (in the tick after the commit)
//   rising edges on the step pins = counted by the drive + lost by the fault script + ignored with the servo off
//   EMITTED registers = rising edges on the step pins              (at the trigger of the snapshot)
//   POSITION registers = encoder counts                (within the latency of the input filter and the input jitter)
//
// The checker counts the pins itself and snoops finished bus accesses. Fewer pulses than committed are legal only when
// the logic reports the reason: the next read of pulse_train FAULT must show RESIDUAL, ESTOP or WATCHDOG. More pulses
// than committed are never legal. A drive may ignore pulses while its servo enable is low, in alarm, and while the
// relay of the drop-out is open.
//
// While the clock of the logic stands still, so do ticks and accesses: their times are counted in edges of that clock.
// The logic loses counts of a motor that moves meanwhile (expected_positions.hpp).
//
// With the logic of Vo 2021 (`paper`) the software commits half periods. The pins must show the number of pulses that
// each half period makes (paper_widths.hpp), STATUS shows a stop, and POSITION is that of the selected axis. After the
// encoder switch has selected another axis during the run, POSITION is the sum of several encoders and of the edges
// that the switching itself caused. It is not checked any more then.
//
// Ticks are numbered by the trigger that ends them, from 0, as in the trace. The trigger pin is the flip-flop output
// that the blocks use. The clock edge after it samples the snapshots and starts the committed counts. A step pin rises
// some cycles later at the earliest, so every edge belongs to exactly one tick.
//
// The checker learns of an access when the core receives its response. The effect in the logic was earlier, by up to
// the latency and stalls of `bus`. If a trigger was in between, both orders are possible and the checker accepts
// either. It then assigns a commit to the tick in which its pulses appear.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "cosim/bus/bus_spec.hpp"
#include "cosim/check/expected_positions.hpp"
#include "cosim/check/paper_widths.hpp"
#include "cosim/logic/pins.hpp"
#include "cosim/plant/plant.hpp"

namespace armature::cosim {

// The logic that is checked.
struct CheckedLogic {
  bool paper = false;         // that of Vo 2021
  bool input_jitter = false;  // see ExpectedPositions
};

class Conservation {
 public:
  // `plant` must outlive the checker. Both start at reset.
  Conservation(const Plant& plant, const BusSpec& bus, CheckedLogic logic = {});

  // The clock of the logic runs, or stands still, after its edge `now`.
  void on_clock(Cycles now, bool runs);
  // From now on the encoders of these axes, one bit each, do not show their motors: POSITION is not checked any more.
  void do_not_check_positions(std::uint8_t axes) { false_encoders_ |= axes; }
  // From now on the logic need not do what it should: nothing is a violation any more.
  void stop_checking() { checks_ = false; }
  // From now on a response may come later by up to this time.
  void allow_late_responses(Cycles delay) {
    access_tail_ += std::max(Cycles{}, delay - allowed_delay_);
    allowed_delay_ = std::max(allowed_delay_, delay);
  }
  // Call after each clock edge on which an output changed, after Plant::on_outputs().
  void on_outputs(Cycles now, const SocOutputs& out);
  // Instead of on_outputs() for the edges of the pulses of a whole tick. Call it before on_trigger() at its end.
  void on_tick(const TickPulses& tick);
  // Call after the edge that raised the trigger pin, after on_outputs() of that cycle.
  void on_trigger(Cycles now);
  // A bus access without error whose response the core receives at `now`. A write that the logic has executed counts,
  // even if a fault turns its response into an error.
  void on_write(Cycles now, std::uint32_t addr, std::uint32_t data);
  void on_read(Cycles now, std::uint32_t addr, std::uint32_t data);
  // Call at the end of the run. Missing pulses without an explanation become a violation.
  void finish();

  // The first violation of the run: tick, axis, cycle, expected, got.
  [[nodiscard]] const std::optional<std::string>& violation() const { return violation_; }

  // Rising edges on the step pin since reset, net of direction.
  [[nodiscard]] std::int64_t pin_pulses(std::size_t axis) const { return pins_[axis]; }
  // Edges on the pins of an axis in a tick; 0: there was none.
  struct PinEdges {
    Cycles first_rise{};  // of step
    Cycles turned{};      // the latest change of dir
  };
  // In the tick that the latest trigger has ended.
  [[nodiscard]] const PinEdges& edges_of_tick(std::size_t axis) const { return edges_of_tick_[axis]; }

 private:
  using CountSet = PerAxis<std::int32_t>;

  struct Shortage {
    std::int64_t tick = 0;
    std::size_t axis = 0;
    Cycles cycle{};  // of the trigger that ended the tick
    Cycles logic_time{};
    std::int32_t committed = 0;
    std::int32_t emitted = 0;
  };

  // Number of edges of the clock of the logic until `now`.
  [[nodiscard]] Cycles logic_time(Cycles now) const { return now - stood_still_; }
  // Whether the last trigger may lie between the effect of an access in the logic and its end at `now`.
  [[nodiscard]] bool trigger_in_doubt(Cycles now) const {
    return triggers_ > 0 && logic_time(now) - trigger_ <= access_tail_;
  }

  void commit(Cycles now);
  void check_tick(Cycles now);
  void explain_mismatch(Cycles now, const CountSet& emitted);
  void check_paper_tick(Cycles now);
  void record_shortage(Cycles now, std::size_t axis, std::int32_t committed, std::int32_t emitted);
  void check_drives(Cycles now);
  void on_paper_write(Cycles now, std::uint32_t addr, std::uint32_t data);
  void on_paper_read(Cycles now, std::uint32_t addr, std::uint32_t data);
  // The software has read from the logic whether it stopped pulses.
  void check_stop(Cycles now, bool stopped);
  void explain_shortage(Cycles now);
  void check_emitted(Cycles now, std::size_t axis, std::uint32_t value);
  void check_position(Cycles now, std::size_t axis, std::uint32_t value);
  [[gnu::cold]] void report_emitted(Cycles now, std::size_t axis, std::uint32_t value);
  [[gnu::cold]] void report_position(Cycles now, std::size_t axis, std::uint32_t value);
  void report(const Shortage& shortage);
  void report(std::int64_t tick, std::size_t axis, Cycles cycle, const std::string& what);

  const Plant& plant_;
  bool paper_;
  Cycles access_tail_;
  Cycles allowed_delay_{};  // in access_tail_
  bool checks_ = true;
  std::uint8_t false_encoders_ = 0;

  // clock
  std::optional<Cycles> stopped_at_;
  Cycles stood_still_{};  // in all, without the present stop

  // pins
  std::uint8_t step_ = 0;
  std::uint8_t dir_ = 0;
  std::uint8_t servo_on_ = 0;
  std::uint8_t servo_was_off_ = 0x3F;  // at some time in this tick
  PerAxis<std::int64_t> pins_{};
  PerAxis<PinEdges> edges_{};  // since the last trigger
  PerAxis<PinEdges> edges_of_tick_{};
  PerAxis<std::int64_t> pins_at_trigger_{};
  PerAxis<std::int64_t> ignored_at_trigger_{};

  // triggers
  std::int64_t triggers_ = 0;
  Cycles trigger_{};                          // logic time of the last one
  PerAxis<std::int64_t> latest_emitted_{};    // pulses on the pins at the last trigger
  PerAxis<std::int64_t> previous_emitted_{};  // at the one before it
  ExpectedPositions positions_;

  // commits
  CountSet staged_{};
  std::vector<CountSet> active_{CountSet{}};   // possible counts of this tick: one set unless a commit is in doubt
  std::vector<CountSet> pending_{CountSet{}};  // the same for the next tick
  bool pending_may_be_active_ = false;         // pending_[0] was committed in doubt: it is also the last of active_
  std::optional<Shortage> shortage_;           // not yet explained
  std::optional<Cycles> stop_seen_;            // logic time of the last read that showed why pulses may be missing

  // the logic of Vo 2021
  PaperWidths widths_;
  std::size_t selected_ = 0;  // encoder connected to the decoder; kAxes and above: none
  bool switched_ = false;     // since the first trigger

  std::optional<std::string> violation_;
};

}  // namespace armature::cosim
