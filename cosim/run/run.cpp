#include "cosim/run/run.hpp"

#include <utility>

#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/report/judge/expect.hpp"
#include "cosim/report/measure/tool_point.hpp"

namespace armature::cosim {
namespace {

constexpr std::int64_t kWriteTicks = 2'000;  // 0.1 s: the most that a killed run loses

}  // namespace

Run::Run(const Scenario& scenario, RunParts parts)
    : scenario_{scenario},
      facts_{scenario, parts.sent_bytes},
      needs_tool_point_{needs_tool_point(scenario)},
      simulation_{scenario, make_soc(scenario), *this, std::move(parts.wave), parts.serial_peer} {}

void Run::on_row(TraceRow& row) {
  if (needs_tool_point_) row.tool_point = facts_.tool_point(row.telemetry);
  digest_.add(row);
  for (RunListener* listener : listeners_) listener->on_row(row, digest_);
  ++ticks_;
  if (row.tick % kWriteTicks != 0) return;
  for (RunListener* listener : listeners_) listener->write_through();
}

void Run::on_event(const Event& event, Cycles now) {
  for (RunListener* listener : listeners_) listener->on_event(event, place(now));
}

void Run::on_action(const ScriptAction& action, Cycles now) {
  for (RunListener* listener : listeners_) listener->on_action(action, place(now));
}

void Run::on_signal(const Signal& signal, Cycles now) {
  for (RunListener* listener : listeners_) listener->on_signal(signal, place(now));
}

RunSummary Run::finish() {
  const SimulationEnd end = simulation_.finish();
  RunSummary summary = summary_before_run(scenario_);
  summary.facts = facts_.facts();
  summary.facts.cycles = end.cycles;
  summary.facts.bus_reads = end.bus_reads;
  summary.facts.bus_writes = end.bus_writes;
  summary.facts.worst_tick = end.worst_tick;
  summary.facts.sha256 = digest_.hex();
  summary.host.whole_ticks = end.whole_ticks;
  summary.wave_written = end.wave_written;
  summary.serial_unsent = end.serial_unsent;
  summary.interrupted = end.reason == EndReason::kInterrupted;
  if (end.reason == EndReason::kFailed) summary.failure = end.failure;
  summary.engines_differ_at = end.engines_differ_at;
  summary.program_end = end.program_end;
  if (end.reason == EndReason::kFinished) {
    summary.expect_results = expect_results(scenario_.expect, summary.facts);
    summary.expect_failures = check(scenario_.expect, summary.facts);
  }
  for (RunListener* listener : listeners_) listener->judge(summary);
  for (RunListener* listener : listeners_) listener->on_end(summary);
  return summary;
}

}  // namespace armature::cosim
