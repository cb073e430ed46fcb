#pragma once

#include <string>

#include "cosim/report/judge/moment_wave.hpp"

namespace armature::cosim {

// The lines about a waveform of --wave-on, without their end: what the first one is about, and the rest.
struct MomentWaveText {
  std::string label;  // `waveform` or `no waveform`
  std::string text;
};
[[nodiscard]] MomentWaveText moment_wave_text(const MomentWaveResult& wave);

}  // namespace armature::cosim
