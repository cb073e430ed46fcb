#include "cosim/run/engine_waves.hpp"

#include <algorithm>
#include <utility>

#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/kernel/simulation.hpp"

namespace armature::cosim {
namespace {

class NoListener final : public SimulationListener {
 public:
  void on_row(TraceRow&) override {}
  void on_event(const Event&, Cycles) override {}
  void on_action(const ScriptAction&, Cycles) override {}
  void on_signal(const Signal&, Cycles) override {}
};

}  // namespace

void write_engine_waves(const Scenario& scenario, Cycles at, const std::filesystem::path& folder,
                        const EngineWaveOptions& options) {
  const Cycles end = at + kWaveAfter;
  WaveRequest wave;
  wave.from = std::max(at - kWaveBefore, Cycles{0});
  wave.to = end;
  Scenario again = scenario;
  for (const auto& [engine, file] :
       {std::pair{Engine::kRtl, kRtlWaveFile}, std::pair{Engine::kModel, kModelWaveFile}}) {
    again.engine = engine;
    wave.file = folder / file;
    NoListener nobody;
    Simulation simulation{again, options.make_soc ? options.make_soc(again) : make_soc(again), nobody, wave};
    // What is due at `end`, such as the end of the waveform, happens after it.
    while (simulation.now() <= end && simulation.advance(simulation.now() + armature::kTickCycles)) {
      if (options.stop_requested && options.stop_requested()) break;
    }
    simulation.finish();
  }
}

}  // namespace armature::cosim
