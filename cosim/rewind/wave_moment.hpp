// What `--wave-on` goes back to: the moments of a run that a user wants to see in a waveform.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "controller/base/units.hpp"
#include "controller/base/words.hpp"
#include "cosim/report/judge/run_summary.hpp"
#include "cosim/rewind/wave_span.hpp"

namespace armature::cosim {

enum class WaveReason : std::uint8_t {
  kFault,     // the controller reports a fault: the first one
  kFail,      // the run ends early by a failure, or does not meet an expectation: the earliest that is known to a cycle
  kMismatch,  // the run differs from its golden: from the last equal row of the golden to the first one that differs
};

// A waveform of one of them.
struct MomentWave {
  WaveReason reason = WaveReason::kFault;
  Cycles before{};  // so long before the moment the waveform begins
  std::optional<Cycles> from{},
      to{};  // moments in this time count; the waveform ends at `to`, or 1 ms after its moment
};

struct MomentWaveRequest {
  MomentWave wanted;
  WaveOutput output;
};

struct WaveMoment {
  std::string what;  // `the fault estop`, `expect.underruns`
  Cycles from{}, to{};
};

// All moments of the wanted kind that count, so far as the run is known. The end of a run is not one of them.
[[nodiscard]] std::vector<WaveMoment> wave_moments(const MomentWave& wanted, const RunSummary& summary);

// The moment that is shown of a run that has ended. An expectation that fails at no certain cycle fails at the end.
// Nothing: there is none.
[[nodiscard]] std::optional<WaveMoment> shown_moment(const MomentWave& wanted, const RunSummary& summary);

[[nodiscard]] WaveSpan span_of(const MomentWave& wanted, const WaveMoment& moment);

}  // namespace armature::cosim
