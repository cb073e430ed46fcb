#include "cosim/report/format/summary_text.hpp"

#include <fmt/format.h>

#include <iterator>

#include "cosim/report/format/injection_text.hpp"
#include "cosim/report/format/refusal_text.hpp"
#include "cosim/report/judge/run_summary.hpp"
#include "cosim/report/measure/tool_point.hpp"
#include "cosim/text/angle_units.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

template <class... Args>
void line(std::string& out, std::string_view label, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), "  {:<22}", label);
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
  out += '\n';
}

void number(std::string& out, double value, int digits) {
  fmt::format_to(std::back_inserter(out), "{:>12.{}f}", value, digits);
}

// A column for each axis that the robot has.
class AxisTable {
 public:
  AxisTable(std::string& out, std::size_t axis_count) : out_{out}, axis_count_{axis_count} {}

  template <class T>
  void add(std::string_view label, const PerAxis<T>& values, int digits = 0) {
    fmt::format_to(std::back_inserter(out_), "  {:<22}", label);
    for (std::size_t i = 0; i < axis_count_; ++i) {
      if constexpr (std::is_floating_point_v<T>) {
        number(out_, values[i], digits);
      } else {
        fmt::format_to(std::back_inserter(out_), "{:>12}", values[i]);
      }
    }
    out_ += '\n';
  }

 private:
  std::string& out_;
  std::size_t axis_count_;
};

void deviation_line(std::string& out, std::string_view label, const std::optional<PathDeviation>& deviation) {
  if (!deviation) return;
  // What is next to nothing is shown as what it is, not as nothing.
  const bool tiny = deviation->mm > 0 && deviation->mm < 1e-4;
  line(out, label, "{} mm at {:.6f} s in move[{}]",
       fmt::format(fmt::runtime(tiny ? "{:.1e}" : "{:.4f}"), deviation->mm), to_seconds(deviation->at),
       deviation->move);
}

// What there is to say about the tool centre point and its moves.
void add_tool(std::string& out, const RunFacts& facts) {
  if (facts.final_tcp_mm) {
    fmt::format_to(std::back_inserter(out), "  {:<22}", "final tcp mm (x y z)");
    for (const double coordinate : *facts.final_tcp_mm) number(out, coordinate, 4);
    out += '\n';
  }
  if (facts.final_rotation) {
    fmt::format_to(std::back_inserter(out), "  {:<22}", "final rpy deg");
    for (const double angle : rpy_deg(*facts.final_rotation)) number(out, angle, 4);
    out += '\n';
  }
  deviation_line(out, "worst path error", facts.path_error);
  deviation_line(out, "  of the set-points", facts.command_path_error);
  if (const MoveStarted* move = facts.most_stretched(); move != nullptr && move->stretch > 1) {
    line(out, "largest stretch", "{:.3f} for {} in move[{}]", move->stretch, mover_name(move->stretched_for),
         move->tag.number());
  }
  for (std::size_t i = 0; i < facts.moves.size(); ++i) {
    const MoveStarted& move = facts.moves[i];
    if (const double off_deg = move.residual_rad * kDegPerRad; off_deg > kNoDeviationDeg) {
      line(out, "orientation missed", "by up to {:.4g} deg in move[{}], five joints cannot take it", off_deg,
           move.tag.number());
    }
    if (facts.blended_with_next(i) == false) line(out, "not blended", "move[{}] stopped at its end", move.tag.number());
  }
}

std::string_view verdict(const RunSummary& summary) {
  if (summary.interrupted) return "INTERRUPTED";
  return summary.passed() ? "PASSED" : "FAILED";
}

void add_events(std::string& out, const RunFacts& facts) {
  for (const GivenInput& input : facts.inputs) {
    line(out, "input", "{} at {}: {}", input_text(input.spec), moment_text(input.when), answer_text(input));
  }
  for (const InjectedFault& fault : facts.injected_faults) {
    line(out, "injected fault", "{} at {}:", fault_text(fault.spec), moment_text(fault.when));
    line(out, "", "{}", answer_text(fault));
  }
  for (const FaultEvent& fault : facts.faults) {
    line(out, "fault", "{}{} at {}", fault_name(fault.cause),
         fault.axis == 0 ? std::string{} : fmt::format(" of axis {}", fault.axis), moment_text({fault.at, fault.tick}));
  }
  if (facts.controller_silent) {
    line(out, "fault", "the logic dropped the servo enables and the controller has not noticed");
  } else if (facts.faults.empty()) {
    line(out, "faults", "none");
  }
  if (!facts.stopped_by.empty()) line(out, "servo enables dropped", "{}", facts.stopped_by);
  for (const RefusedMove& refused : facts.refusals) {
    const bool dropped = is_drop(refused.refusal.reason);
    line(out, dropped ? "not carried out" : "refused", "move[{}] {} ({:.6f} s)", refused.refusal.tag.number(),
         refusal_text(refused.refusal), to_seconds(refused.at));
  }
}

}  // namespace

std::string summary_text(const RunSummary& summary) {
  const RunFacts& facts = summary.facts;
  std::string out =
      fmt::format("{} {}: {}\n", verdict(summary), printable(summary.scenario), printable(summary.description));
  line(out, "robot", "{}", printable(summary.robot));
  if (summary.variant == Variant::kPaper)
    line(out, "variant", "paper: half periods for counts, one decoder for all encoders");
  line(out, "outcome", "{}", summary.failure ? *summary.failure : std::string{summary.outcome()});
  line(out, "simulated time", "{:.6f} s, {} ticks, {} cycles", summary.simulated_s(), facts.ticks,
       summary.cycles.value());
  line(out, "host time", "{:.2f} s, {:.2f} Mcycles/s, real-time factor {:.3f}", summary.host.wall_s,
       summary.cycles_per_s() / 1e6, summary.real_time_factor());
  line(out, "bus accesses", "{} reads, {} writes", summary.bus_reads, summary.bus_writes);
  line(out, "worst tick", "{} of {} cycles ({:.1f} %)", summary.worst_tick.value(), kTickCycles,
       100.0 * static_cast<double>(summary.worst_tick.value()) / static_cast<double>(kTickCycles));
  const bool unfinished = facts.moves_waiting != 0 || facts.moves_under_way != 0;
  line(out, "moves", "{} started, {} finished, {} refused or dropped{}", facts.moves.size(), facts.moves_finished,
       facts.refusals.size(),
       unfinished ? fmt::format(", {} waiting and {} under way at the end", facts.moves_waiting, facts.moves_under_way)
                  : std::string{});
  if (facts.held_s > 0) line(out, "stood in a Hold", "{:.6f} s", facts.held_s);
  line(out, "underruns", "{}", facts.underruns);
  if (!facts.serial_sent.empty() || facts.serial_errors > 0) {
    line(out, "serial line", "{} bytes from the controller, {} errors or breaks", facts.serial_sent.size(),
         facts.serial_errors);
  }
  if (summary.serial_unsent > 0) {
    line(out, "serial line", "{} characters or breaks to the controller still waited at the end",
         summary.serial_unsent);
  }
  for (const OutputChange& change : facts.outputs) {
    line(out, "output", "pin {} = {} at {:.6f} s", change.pin, change.level ? 1 : 0, to_seconds(change.at));
  }
  AxisTable axes{out, facts.axis_count};
  axes.add("axis", PerAxis<int>{1, 2, 3, 4, 5, 6});
  axes.add("final angle deg", facts.final_joint_deg, 4);
  axes.add("peak speed deg/s", facts.peak_speed_deg_s, 3);
  axes.add("worst following deg", facts.worst_following_error_deg, 4);
  axes.add("final error counts", facts.final_error_counts);
  axes.add("pulses", facts.total_pulses);
  if (summary.variant == Variant::kPaper) {
    axes.add("inexact ticks", facts.inexact_ticks);
    axes.add("encoder counts lost", facts.lost_counts);
    line(out, "largest residual", "{} pulses", facts.max_residual_pulses);
  }
  add_tool(out, facts);
  add_events(out, facts);
  if (!summary.sha256.empty()) line(out, "sha256", "{}", summary.sha256);
  if (!summary.golden.text.empty()) line(out, "golden", "{}: {}", summary.golden.word(), summary.golden.text);
  out += summary.golden.details;
  for (const ExpectFailure& failure : summary.expect_failures) line(out, "not met", "{}", failure.text());
  return out;
}

}  // namespace armature::cosim
