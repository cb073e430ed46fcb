// Finds which pulses the logic emitted in which tick, from the commits and the reports of the logic.
//
// A trigger activates the committed set, if there is one. Without one the tick after it emits nothing (underrun). This
// core may be late by any number of ticks, so none, one or several triggers may have passed between two samples.
//
// A program error may commit a set that this core does not know. What it emits is in the EMITTED registers only.
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
    if (uncertain_ > 0) --uncertain_;
    if (is_waiting_ && active_sequence == sequence_) {
      on_tick_ended(active_);
      active_ = waiting_;
      is_waiting_ = false;
    } else if (has_active_sequence_ && active_sequence != active_sequence_) [[unlikely]] {
      on_tick_ended(active_);
      active_ = {};
      is_waiting_ = false;  // the unknown set has replaced it
      uncertain_ = 2;
    }
    active_sequence_ = active_sequence;
    has_active_sequence_ = true;
    for (std::uint32_t i = 0; i < underruns; ++i) {
      on_tick_ended(active_);
      active_ = {};
    }
  }

  // The ticks that observe() has found up to now need not have emitted what it said: the logic has activated a set that
  // was not committed by committed().
  [[nodiscard]] bool uncertain() const noexcept { return uncertain_ > 0; }

  // The set that the logic emits now; nothing if it is unknown.
  [[nodiscard]] const PerAxis<Pulses>& active() const noexcept { return active_; }

  // Resets the state: no pulses are emitted and no set waits.
  void reset() noexcept { *this = {}; }

 private:
  PerAxis<Pulses> active_{};
  PerAxis<Pulses> waiting_{};
  std::uint16_t sequence_ = 0;
  bool is_waiting_ = false;
  bool has_active_sequence_ = false;
  std::uint16_t active_sequence_ = 0;  // of the sample before
  int uncertain_ = 0;                  // samples
};

}  // namespace armature
