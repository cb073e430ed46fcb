// A run of a scenario: simulates it, measures it, judges it. Listeners record and show it.
//
//   Run run{scenario};
//   run.add(trace);
//   while (run.advance(run.now() + step)) {}
//   const RunSummary summary = run.finish();
//
// The result does not depend on the steps. Runs share nothing, so several of them can take turns in one thread, or run
// in several threads. A run reads no wall clock and waits for nobody.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/report/judge/run_summary.hpp"
#include "cosim/run/facts_listener.hpp"
#include "cosim/run/run_listener.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/integer_digest.hpp"

namespace armature::cosim {

// What a run may have besides its scenario.
struct RunParts {
  std::optional<WaveRequest> wave{};
  SerialPeer* serial_peer = nullptr;  // as in Simulation
  SentBytes sent_bytes = SentBytes::kKept;
};

class Run final : private SimulationListener {
 public:
  // The scenario and the peer must outlive the run.
  explicit Run(const Scenario& scenario, RunParts parts = {});
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  // Call it before the first advance(). The listener must outlive the run.
  void add(RunListener& listener) { listeners_.push_back(&listener); }

  // Continues up to the cycle `until`, or to the end of the run. What is due in the cycle `until` itself happens in the
  // next call. Returns false when the run is over. Throws what a listener throws, and std::runtime_error when the
  // waveform cannot be written; the run cannot continue then.
  bool advance(Cycles until) { return simulation_.advance(until); }
  // Ends a run that is not over. Such a run is not judged.
  void interrupt() { simulation_.interrupt(); }
  [[nodiscard]] Cycles now() const { return simulation_.now(); }

  // ---- between two steps
  // What is measured so far. Its counts of cycles and accesses are those of the end only.
  [[nodiscard]] RunFacts facts() const { return facts_.facts(); }
  [[nodiscard]] const std::vector<FaultEvent>& faults() const { return facts_.faults(); }
  [[nodiscard]] SimulationState look() { return simulation_.look(); }
  // As of Simulation.
  [[nodiscard]] BusResponse read_and_spoil(std::uint32_t address) { return simulation_.read_and_spoil(address); }
  void add_action(const FaultSpec& fault) { simulation_.add(fault); }
  void add_action(const InputSpec& input) { simulation_.add(input); }
  void add_action(const CommandSpec& command) { simulation_.add(command); }
  void add_action(const StreamStep& step) { simulation_.add(step); }
  void end_fault(const FaultSpec& fault) { simulation_.end_fault(fault); }
  [[nodiscard]] std::vector<Flop> flops() { return simulation_.flops(); }
  [[nodiscard]] std::uint64_t logic_digest() { return simulation_.logic_digest(); }
  [[nodiscard]] const CoreMemory& core_memory() const { return simulation_.core_memory(); }
  [[nodiscard]] std::optional<std::uint64_t> core_digest() const { return simulation_.core_digest(); }
  void write_wave(WaveRequest wave) { simulation_.write_wave(std::move(wave)); }
  void close_wave() { simulation_.close_wave(); }

  // Call it once. A run that is not over ends as interrupted. The summary has no wall time.
  RunSummary finish();

 private:
  void on_row(TraceRow& row) override;
  void on_event(const Event& event, Cycles now) override;
  void on_action(const ScriptAction& action, Cycles now) override;
  void on_signal(const Signal& signal, Cycles now) override;
  [[nodiscard]] RunPlace place(Cycles now) const { return {.tick = ticks_, .at = now}; }

  const Scenario& scenario_;
  FactsListener facts_;
  std::vector<RunListener*> listeners_{&facts_};
  bool needs_tool_point_ = false;  // a report or a listener does
  IntegerDigest digest_;
  std::int64_t ticks_ = 0;  // that have ended
  Simulation simulation_;
};

}  // namespace armature::cosim
