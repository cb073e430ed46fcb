// Snapshots of a run by fork(), so that the waveform of a moment that has passed costs no second run. The engine must
// have the signals: not Engine::kModel. The run must have no peer at its serial line, which could not say all again.
//
// A snapshot that is needed continues beside the run and writes the waveform. The results of the run do not depend on
// it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "controller/base/units.hpp"
#include "cosim/report/judge/run_summary.hpp"
#include "cosim/rewind/wave_moment.hpp"
#include "cosim/rewind/wave_span.hpp"
#include "cosim/run/golden_listener.hpp"
#include "cosim/run/run.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/snapshot/waiting_copy.hpp"

namespace armature::cosim {

class WaveSnapshots {
 public:
  struct Parts {
    const Scenario& scenario;
    Run& run;
    const GoldenListener* golden;  // of the run; null: it has none
    std::function<bool()> stop_requested;
  };
  // What `parts` refers to must outlive this.
  WaveSnapshots(Parts parts, MomentWaveRequest request);

  // To be called before the first step of the run and after each. The steps are shorter than kEvery.
  void after_step();
  // The moment of the waveform that is being written already; none: only the end of the run decides.
  [[nodiscard]] const std::optional<WaveMoment>& ordered() const { return ordered_; }
  // After the end of the run, with ordered() or what shown_moment() returns. Waits for the waveform. Returns the cycle
  // at which it ends, or nothing if no snapshot could write it. Throws std::runtime_error when the file cannot be
  // written.
  [[nodiscard]] std::optional<Cycles> write(const WaveMoment& moment);

  // Between two snapshots: 5 ms, or the time before a moment if that is longer.
  static constexpr Cycles kEvery{kClkFreqHz / 200};

 private:
  struct Snapshot {
    Cycles at{};
    WaitingCopy copy;
  };
  struct Pin {
    Cycles from{};
    std::shared_ptr<Snapshot> snapshot;
  };

  void look_for_moments();
  void take();
  [[noreturn]] void write_in_copy(WokenCopy& woken);
  void order(const WaveMoment& moment);
  [[nodiscard]] std::shared_ptr<Snapshot> latest_before(Cycles at) const;

  Parts parts_;
  MomentWave wanted_;
  WaveOutput output_;
  std::optional<WaveMoment> ordered_;
  Cycles every_;
  std::size_t kept_;
  Cycles next_{};
  RunSummary so_far_;
  std::deque<std::shared_ptr<Snapshot>> latest_;
  std::shared_ptr<Snapshot> ending_;  // is given the time until the next one to end
  std::map<std::string, Pin> pins_;   // by WaveMoment::what: snapshots before moments that may be shown at the end
  std::shared_ptr<Snapshot> chosen_;
};

}  // namespace armature::cosim
