// Which pulses the logic emits in which tick, told from what was committed and what the logic reports.
//
// A trigger activates the set that waits for it, or none: then the tick after it emits nothing (underrun). This core
// may be late by any number of ticks, so between two looks none, one or several triggers may have passed.
#pragma once

#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"

namespace armature {

class Emission {
 public:
  // `counts` have been committed under `sequence`. The set before has been activated.
  void committed(const PerAxis<Pulses>& counts, std::uint16_t sequence) noexcept {
    waiting_ = counts;
    sequence_ = sequence;
    is_waiting_ = true;
  }

  // Looks at the logic: `active_sequence` is that of the set activated last, `underruns` their number since the last
  // look. Calls on_tick_ended(counts) for every tick that has ended since then, in order. Of a set and underruns found
  // together the set is taken to have come first, as it does when this core overslept.
  template <class OnTickEnded>
  void observe(std::uint16_t active_sequence, std::uint32_t underruns, OnTickEnded on_tick_ended) noexcept {
    if (is_waiting_ && active_sequence == sequence_) {
      on_tick_ended(active_);
      active_ = waiting_;
      is_waiting_ = false;
    }
    for (std::uint32_t i = 0; i < underruns; ++i) {
      on_tick_ended(active_);
      active_ = {};
    }
  }

  // Nothing is being emitted and nothing waits.
  void reset() noexcept { *this = {}; }

 private:
  PerAxis<Pulses> active_{};
  PerAxis<Pulses> waiting_{};
  std::uint16_t sequence_ = 0;
  bool is_waiting_ = false;
};

}  // namespace armature
