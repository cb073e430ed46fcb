// A waveform of some cycles of a run.
#pragma once

#include <filesystem>
#include <functional>

#include "controller/base/units.hpp"
#include "cosim/run/run.hpp"

namespace armature::cosim {

// The cycles that a waveform has.
struct WaveSpan {
  Cycles from{}, to{};
};

// Where it is written.
struct WaveOutput {
  std::filesystem::path file;
  WaveFormat format = WaveFormat::kVcd;
};

// Advances the run through the span and writes its waveform: the same file as WaveRequest gives in one run. Returns the
// cycle at which the waveform ends: that of the span, or the end of the run, or where `stop_requested` ends it, which
// is called often. The run is not behind the start of the span. Throws std::runtime_error when the file cannot be
// written.
Cycles write_span(Run& run, const WaveSpan& span, const WaveOutput& output,
                  const std::function<bool()>& stop_requested);

}  // namespace armature::cosim
