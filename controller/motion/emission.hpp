// Finds which pulses the logic emitted in which tick, from the commits and the reports of the logic.
//
// A trigger activates the committed set, if there is one. Without one the tick after it emits nothing (underrun). This
// core may be late by any number of ticks, so none, one or several triggers may have passed between two samples.
//
// A program error may commit a set that this core does not know, and a flipped flop of the logic may lose a set or
// commit one again. What was emitted then is in the EMITTED registers only.
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

  // Processes one sample of the logic: `active_sequence` is that of the last activated set, `pending` says that a set
  // waits in the logic, `underruns` is the number of underruns since the last sample. Calls on_tick_ended(counts) for
  // every tick that has ended since then, in order. If a set and underruns are found together, the set came first, as
  // it does when this core was late.
  template <class OnTickEnded>
  void observe(std::uint16_t active_sequence, bool pending, std::uint32_t underruns,
               OnTickEnded on_tick_ended) noexcept {
    if (uncertain_ > 0) --uncertain_;
    if (is_waiting_ && active_sequence == sequence_) {
      on_tick_ended(active_);
      active_ = waiting_;
      is_waiting_ = false;
    } else if (has_active_sequence_ && active_sequence != active_sequence_) [[unlikely]] {
      end_tick(on_tick_ended);  // the unknown set has replaced it
      is_waiting_ = false;
      uncertain_ = kUncertain;
    } else if (is_waiting_ && !pending) [[unlikely]] {
      if (underruns == 0) end_tick(on_tick_ended);  // it was activated under the number of the set before
      is_waiting_ = false;
      uncertain_ = kUncertain;
    }
    if (!is_waiting_ && pending) [[unlikely]]
      uncertain_ = kUncertain;  // this core has not committed that set
    active_sequence_ = active_sequence;
    has_active_sequence_ = true;
    for (std::uint32_t i = 0; i < underruns; ++i) end_tick(on_tick_ended);
  }

  // The set of committed() waits for its trigger. Another one must not be committed.
  [[nodiscard]] bool is_waiting() const noexcept { return is_waiting_; }

  // The ticks that observe() has found up to now need not have emitted what it said: the logic has activated, lost or
  // received a set otherwise than committed() said.
  [[nodiscard]] bool uncertain() const noexcept { return uncertain_ > 0; }

  // The set that the logic emits now; nothing if it is unknown.
  [[nodiscard]] const PerAxis<Pulses>& active() const noexcept { return active_; }

  // Resets the state: no pulses are emitted and no set waits.
  void reset() noexcept { *this = {}; }

 private:
  // Samples: EMITTED contains a set one trigger after its activation.
  static constexpr int kUncertain = 2;

  // The next tick emits nothing, as far as is known.
  template <class OnTickEnded>
  void end_tick(OnTickEnded& on_tick_ended) noexcept {
    on_tick_ended(active_);
    active_ = {};
  }

  PerAxis<Pulses> active_{};
  PerAxis<Pulses> waiting_{};
  std::uint16_t sequence_ = 0;
  bool is_waiting_ = false;
  bool has_active_sequence_ = false;
  std::uint16_t active_sequence_ = 0;  // of the sample before
  int uncertain_ = 0;                  // samples to come
};

}  // namespace armature
