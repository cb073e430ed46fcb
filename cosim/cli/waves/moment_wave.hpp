// The waveform of --wave-on: of a moment that is known only when it has passed.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "cosim/report/judge/moment_wave.hpp"
#include "cosim/report/judge/run_summary.hpp"
#include "cosim/rewind/wave_moment.hpp"
#include "cosim/rewind/wave_snapshots.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// A run that has ended, and how it is done again if no snapshot has the moment.
struct EndedRun {
  const Scenario& scenario;
  const RunSummary& summary;
  std::function<bool()> stop_requested;          // called often
  WaveSnapshots* snapshots = nullptr;            // null: none were taken
  std::optional<std::filesystem::path> heard{};  // serial.csv of a run with a program at its serial line
  bool show_progress = false;                    // on stderr, if that is a terminal
};

// Writes the waveform. Without snapshots it runs the scenario again up to the moment, on the RTL if the engine was the
// model. Throws std::runtime_error when the file cannot be written.
[[nodiscard]] MomentWaveResult write_moment_wave(const MomentWaveRequest& request, const EndedRun& run);

}  // namespace armature::cosim
