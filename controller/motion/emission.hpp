// Finds which pulses the logic emitted in which tick, from the commits and the reports of the logic.
//
// A trigger activates the committed set, if there is one. Without one the tick after it emits nothing (underrun). This
// core may be late by any number of ticks, so none, one or several triggers may have passed between two samples.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"

namespace armature {

class Emission {
 public:
  // `counts` were committed under `sequence`. The previous set has been activated.
  void committed(const PerAxis<Pulses>& counts, std::uint16_t sequence) noexcept {
    waiting_ = counts;
    sequence_ = sequence;
    is_waiting_ = true;
  }

  // Processes one sample of the logic: `active_sequence` is that of the last activated set, `underruns` the number of
  // underruns since the last sample. Calls on_tick_ended(counts) for every tick that has ended since then, in order. If
  // a set and underruns are found together, the set came first, as it does when this core was late.
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

  // Resets the state: no pulses are emitted and no set waits.
  void reset() noexcept { *this = {}; }

 private:
  PerAxis<Pulses> active_{};
  PerAxis<Pulses> waiting_{};
  std::uint16_t sequence_ = 0;
  bool is_waiting_ = false;
};

}  // namespace armature
