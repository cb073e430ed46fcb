// The waveforms of both engines around the first difference that a run in lock-step has found.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>

#include "controller/base/timebase.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim {

// The files that write_engine_waves() writes into a folder: every signal of the RTL, the pins of the model.
inline constexpr const char* kRtlWaveFile = "lockstep_rtl.vcd";
inline constexpr const char* kModelWaveFile = "lockstep_model.vcd";
inline constexpr std::array kEngineWaveFiles{kRtlWaveFile, kModelWaveFile};

// The part of the run in the files, before and after the difference.
inline constexpr Cycles kWaveBefore{2 * armature::kTickCycles.value()};
inline constexpr Cycles kWaveAfter = armature::kTickCycles;

struct EngineWaveOptions {
  // Makes the chip with the engine that the scenario chooses; empty: that of every run.
  std::function<std::unique_ptr<Soc>(const Scenario& scenario)> make_soc{};
  std::function<bool()> stop_requested{};  // ends both runs early; empty: never. Called every tick
};

// Runs the scenario again up to the difference at cycle `at` and a little further, once with each engine. Up to `at`
// both runs are the one in lock-step; then each engine moves the arm on its own, until its run fails. The scenario must
// need no program at the other end of its serial line. Throws WaveError when a file cannot be written.
void write_engine_waves(const Scenario& scenario, Cycles at, const std::filesystem::path& folder,
                        const EngineWaveOptions& options = {});

}  // namespace armature::cosim
