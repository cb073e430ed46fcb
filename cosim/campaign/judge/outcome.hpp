// How a run of a campaign ends: in exactly one of these ways.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"
#include "controller/base/words.hpp"

namespace armature::cosim {

enum class Outcome : std::uint8_t {
  kFinished,  // at its end within the tolerance, and no count is lost
  kStopped,   // by the right fault and in time, or the operator was told why not all was done
  kMasked,    // nothing differs from the run without the fault
  // ---- silent errors
  kWrongPosition,    // the arm or the controller's idea of it is somewhere else, and nobody says so
  kMotionAfterStop,  // pulses, motion or servo power after the servo power was taken away
  kLimitExceeded,    // a joint passed the end of its range, or was too fast
  kHang,             // neither at the end nor stopped
  kServosOn,         // a stop was demanded, and servo power stayed on
  kTooLate,          // the arm was farther off its path than the following error allows, before anything was detected
  kWrongFault,       // stopped without a reason, or another axis is blamed
  kFailed,           // the run was broken off: an invariant does not hold
};

[[nodiscard]] constexpr bool is_silent(Outcome outcome) {
  return outcome > Outcome::kMasked;
}

// `wrong position`
[[nodiscard]] inline std::string outcome_text(Outcome outcome) {
  std::string text{word_of(outcome)};
  for (char& letter : text) {
    if (letter == '_') letter = ' ';
  }
  return text;
}

struct Verdict {
  Outcome outcome = Outcome::kFinished;
  std::string reason{};                         // of what is not masked and not finished
  std::optional<std::int64_t> latency_ticks{};  // from the begin of the first fault to the first response
};

// Rounded up.
[[nodiscard]] constexpr std::int64_t ticks_between(Cycles from, Cycles to) {
  return ((to - from).value() + armature::kTickCycles.value() - 1) / armature::kTickCycles.value();
}

}  // namespace armature::cosim
