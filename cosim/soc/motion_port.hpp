// Whole ticks at the chip: an engine that has this port can leave out the edges of pulses and encoder lines in a tick.
// The client then moves the motors by the pulses of the whole tick (Plant) and tells the counts that the next trigger
// copies. Neither side computes an edge, and the pins step, dir, enc_a, enc_b and enc_z stand still.
//
// The order in each tick, at the edges T of the trigger pin:
//   T + 1   begin(): the pulses of the tick. leave_out() in the first of several whole ticks, then expect() for the
//           next trigger. If anything says no, or something disturbs the tick later: continue_after() this edge, and
//           catch_up() to now.
//   T'      finish(), when the trigger pin rises at the end of the tick: all pulses have left.
#pragma once

#include <optional>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "cosim/bus/bus_access.hpp"
#include "cosim/logic/whole_tick.hpp"

namespace armature::cosim {

class MotionPort {
 public:
  virtual ~MotionPort() = default;

  // What the decoders need: a level must last longer than `latency`, a trigger after the edge T copies the counts of
  // the edge T - `latency`, and LineHistory must have the last `history` edges.
  struct DecoderTimes {
    Cycles latency{}, history{};
  };
  [[nodiscard]] virtual DecoderTimes decoder_times() const = 0;

  // The pulses of the tick that has begun at now(); none: only its edges say them.
  [[nodiscard]] virtual std::optional<TickPulses> begin() const = 0;
  // Leaves out edges from now() on. `history`: up to now(). Returns false, and changes nothing, if the state of the
  // decoders does not follow from the lines.
  [[nodiscard]] virtual bool leave_out(const LineHistory& history) = 0;
  // The counts that the coming trigger copies, and for each axis the count at which an index has come in this tick.
  // Returns false if an index does not fit to the one before it.
  [[nodiscard]] virtual bool expect(const PerAxis<Counts>& counts, const PerAxis<std::optional<Counts>>& index) = 0;
  virtual void finish(const TickPulses& pulses) = 0;

  // Whether an access may see or change what is left out, or change the pulses of the tick.
  [[nodiscard]] virtual bool disturbs(const BusRequest& request) const = 0;
  // Computes all edges again, after the edge `at`: the start of a tick (`begun`), or the edge before it. `history`: up
  // to `at`.
  virtual void continue_after(Cycles at, const LineHistory& history, bool begun) = 0;
  // The edges of the latest changes of the pulses then; for the drives.
  struct StepPins {
    PerAxis<Cycles> changed{}, turned{};
  };
  [[nodiscard]] virtual StepPins step_pins() const = 0;
  // The edges of pulses and lines after `from` up to `until`, or to the first one at which step or dir changes: the
  // last one that was computed. `lines`: before these edges. outputs() has the new levels.
  virtual Cycles catch_up(Cycles from, Cycles until, const EncoderLines& lines) = 0;
};

}  // namespace armature::cosim
