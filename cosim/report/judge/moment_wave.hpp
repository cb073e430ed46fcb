// What --wave-on has written of a run, or why it has not.
#pragma once

#include <string>

#include "controller/base/units.hpp"

namespace armature::cosim {

struct MomentWaveResult {
  std::string file{};     // path as the user gave it, or below the folder of the results
  std::string why_not{};  // empty: it is written
  // ---- of a waveform that is written
  std::string moment{};  // `the fault estop`, `expect.underruns`
  Cycles at{};           // when the moment is known to have happened
  Cycles from{}, to{};   // the waveform has the cycles from `from` to before `to`
  [[nodiscard]] bool written() const { return why_not.empty(); }
};

}  // namespace armature::cosim
