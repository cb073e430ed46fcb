#include <fmt/format.h>

#include <iterator>

#include "cosim/kernel/clock.hpp"
#include "cosim/report/run_summary.hpp"
#include "cosim/text/names.hpp"

namespace armature::cosim {
namespace {

template <class... Args>
void line(std::string& out, std::string_view label, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), "  {:<22}", label);
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
  out += '\n';
}

template <class T>
void axis_line(std::string& out, std::string_view label, const PerAxis<T>& values, int digits) {
  fmt::format_to(std::back_inserter(out), "  {:<22}", label);
  for (const T& value : values) {
    if constexpr (std::is_floating_point_v<T>) {
      fmt::format_to(std::back_inserter(out), "{:>12.{}f}", value, digits);
    } else {
      fmt::format_to(std::back_inserter(out), "{:>12}", value);
    }
  }
  out += '\n';
}

std::string_view verdict(const RunSummary& summary) {
  if (summary.interrupted) return "INTERRUPTED";
  return summary.passed() ? "PASSED" : "FAILED";
}

void add_events(std::string& out, const RunFacts& facts) {
  for (const FaultEvent& fault : facts.faults) {
    line(out, "fault", "{}{} at {:.6f} s", fault_name(fault.cause),
         fault.axis == 0 ? std::string{} : fmt::format(" of axis {}", fault.axis), to_seconds(fault.at));
  }
  if (facts.controller_silent) {
    line(out, "fault", "the logic dropped the servo enables and the controller has not noticed");
  } else if (facts.faults.empty()) {
    line(out, "faults", "none");
  }
  if (!facts.stopped_by.empty()) line(out, "servo enables dropped", "{}", facts.stopped_by);
  for (const RefusedMove& refused : facts.refusals) {
    line(out, "refused move", "{}{} at {:.6f} s", refusal_name(refused.refusal.reason),
         refused.refusal.axis == 0 ? std::string{} : fmt::format(", axis {}", refused.refusal.axis),
         to_seconds(refused.at));
  }
}

}  // namespace

double RunSummary::simulated_s() const {
  return to_seconds(cycles);
}
double RunSummary::cycles_per_s() const {
  return host.wall_s > 0 ? static_cast<double>(cycles.value()) / host.wall_s : 0;
}
double RunSummary::real_time_factor() const {
  return host.wall_s > 0 ? simulated_s() / host.wall_s : 0;
}

std::string summary_text(const RunSummary& summary) {
  const RunFacts& facts = summary.facts;
  std::string out = fmt::format("{} {}: {}\n", verdict(summary), summary.scenario, summary.description);
  line(out, "robot", "{}", summary.robot);
  line(out, "outcome", "{}", summary.failure ? *summary.failure : std::string{facts.outcome()});
  line(out, "simulated time", "{:.6f} s, {} ticks, {} cycles", summary.simulated_s(), facts.ticks,
       summary.cycles.value());
  line(out, "host time", "{:.2f} s, {:.2f} Mcycles/s, real-time factor {:.3f}", summary.host.wall_s,
       summary.cycles_per_s() / 1e6, summary.real_time_factor());
  line(out, "bus accesses", "{} reads, {} writes", summary.bus_reads, summary.bus_writes);
  line(out, "worst tick", "{} of {} cycles ({:.1f} %)", summary.worst_tick.value(), kTickCycles,
       100.0 * static_cast<double>(summary.worst_tick.value()) / static_cast<double>(kTickCycles));
  line(out, "moves", "{} started, {} finished, {} refused", facts.moves.size(), facts.moves_finished,
       facts.refusals.size());
  line(out, "underruns", "{}", facts.underruns);
  axis_line(out, "axis", PerAxis<int>{1, 2, 3, 4, 5, 6}, 0);
  axis_line(out, "final angle deg", facts.final_joint_deg, 4);
  axis_line(out, "peak speed deg/s", facts.peak_speed_deg_s, 3);
  axis_line(out, "worst following deg", facts.worst_following_error_deg, 4);
  axis_line(out, "final error counts", facts.final_error_counts, 0);
  axis_line(out, "pulses", facts.total_pulses, 0);
  add_events(out, facts);
  if (!summary.sha256.empty()) line(out, "sha256", "{}", summary.sha256);
  if (!summary.golden.verdict_line.empty()) line(out, "golden", "{}", summary.golden.verdict_line);
  for (const ExpectFailure& failure : summary.expect_failures) line(out, "not met", "{}", failure.text());
  return out;
}

}  // namespace armature::cosim
