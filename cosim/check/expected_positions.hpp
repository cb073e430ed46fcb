// What the POSITION registers must read, for the conservation checker.
//
// POSITION counts from 0, wherever the encoder stands at the start. A change of an encoder pin is in POSITION after the
// latency of the input filter. So POSITION is one of the counts that the encoder showed within that latency before the
// trigger.
//
// With input jitter the logic samples each level of A and B at a clock edge or at the one after it, each change by
// itself. At every edge the logic therefore sees A as it was at this edge or at the one before, and so for B. One count
// lasts several cycles, so at most one of the lines has changed in between: the logic sees one of the counts of these
// two edges. The latency becomes one cycle longer and no more.
//
// While the clock of the logic stands still, the decoder does not see the edges of a motor that moves. From then on
// POSITION differs from the count of the encoder by another constant. How many counts are lost depends on the levels
// before and after: the checker knows the number to within kMaxFollowed counts, and learns the rest from the reads.
#pragma once

#include <cstddef>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "cosim/plant/plant.hpp"

namespace armature::cosim {

// What is between the pins of the encoders and the decoder.
struct EncoderPath {
  bool switched = false;      // the encoder switch
  bool input_jitter = false;  // changes arrive up to a cycle later (cosim/fabric/jittery_fabric.hpp)
};

class ExpectedPositions {
 public:
  // `plant` must outlive this object.
  ExpectedPositions(const Plant& plant, EncoderPath path);

  // The software has written the debounce time [cycles]; 0 acts as 1.
  void set_debounce(std::int64_t time) { debounce_ = time; }

  // The snapshot is taken at `now`. `trigger_in_doubt`: a read that ends after it may have come before the last
  // trigger, or before the one before that. A timer with a wrong period triggers that often.
  void on_trigger(Cycles now, bool trigger_in_doubt);

  // The clock has stopped after its edge `now`; it runs again from the edge after `now`.
  void on_clock_stopped(Cycles now);
  void on_clock_started(Cycles now);

  // Whether POSITION may read `value`. `trigger_in_doubt`: the read may have come before the last trigger.
  [[nodiscard]] bool accepts(std::size_t axis, std::uint32_t value, bool trigger_in_doubt);

  // The values that are possible after the last trigger.
  [[nodiscard]] CountRange latest(std::size_t axis) const { return latest_[axis]; }

  // The decoder counts at most so many edges of what happened while the clock stood still: one that was in the filter,
  // one for the new levels (two with input jitter, if A and B changed and one of them is late), and one that follows
  // within the debounce time. One turn of A and B covers them.
  static constexpr Counts kMaxFollowed{4};

 private:
  [[nodiscard]] Cycles latency() const;
  // A change of the encoder after this cycle may not yet be in POSITION.
  [[nodiscard]] Cycles settled_until(Cycles now) const;

  const Plant& plant_;
  std::int64_t path_;  // cycles from a change of an encoder pin to the position, without the debounce time
  std::int64_t debounce_;
  std::int64_t previous_debounce_;
  Cycles running_since_{};
  bool settled_ = true;  // at the last trigger every edge from before the last stop of the clock was in POSITION
  PerAxis<CountRange> latest_{};    // of the last trigger
  PerAxis<CountRange> previous_{};  // of the one before it, and of others as near
  PerAxis<CountRange> shown_{};     // when the clock stopped
  PerAxis<CountRange> lost_{};      // POSITION minus the count of the encoder; at first minus its count at the start
};

}  // namespace armature::cosim
