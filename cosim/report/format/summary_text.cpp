#include "cosim/report/format/summary_text.hpp"

#include <fmt/format.h>

#include <utility>

#include "controller/base/angle_units.hpp"
#include "cosim/report/format/fact_lines.hpp"
#include "cosim/report/format/injection_text.hpp"
#include "cosim/report/format/program_note_text.hpp"
#include "cosim/report/format/refusal_text.hpp"
#include "cosim/report/format/screen_line.hpp"
#include "cosim/report/judge/run_summary.hpp"
#include "cosim/scenario/fault_text.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

template <class... Args>
void line(std::string& out, std::string_view label, fmt::format_string<Args...> format, Args&&... args) {
  add_line(out, label, fmt::format(format, std::forward<Args>(args)...));
}

// `, 1 waiting (still planning) and 1 under way at the end`
std::string unfinished_text(const RunFacts& facts) {
  if (facts.moves_waiting == 0 && facts.moves_under_way == 0) return {};
  return fmt::format(", {} waiting{} and {} under way at the end", facts.moves_waiting,
                     facts.planning ? " (still planning)" : "", facts.moves_under_way);
}

// The move that is executed at the end of the run.
void add_move_under_way(std::string& out, const RunFacts& facts) {
  const auto first = std::ssize(facts.moves) - facts.moves_under_way;
  if (facts.moves_under_way == 0 || first < 0) return;
  const MoveStarted& move = facts.moves[static_cast<std::size_t>(first)];
  line(out, "under way", "{}; as planned, its set-points end at {:.4f} s", facts.names.of(move.tag),
       static_cast<double>((move.start_tick + move.duration).value()) * kTickSeconds);
}

// Moves of the tool that differ from their commands.
void add_moves(std::string& out, const RunFacts& facts) {
  if (const MoveStarted* move = facts.most_stretched(); move != nullptr && move->stretch > 1) {
    line(out, "largest stretch", "{:.3f} for {} in {}", move->stretch, mover_name(move->stretched_for),
         facts.names.of(move->tag));
  }
  for (std::size_t i = 0; i < facts.moves.size(); ++i) {
    const MoveStarted& move = facts.moves[i];
    if (const double off_deg = move.residual_rad * kDegPerRad; off_deg > kNoDeviationDeg) {
      line(out, "orientation missed", "by up to {:.4g} deg in {}, {}", off_deg, facts.names.of(move.tag),
           facts.axis_count == kAxes ? "at a wrist singularity" : "five joints cannot reach it");
    }
    if (facts.blended_with_next(i) == false)
      line(out, "not blended", "{} stopped at its end", facts.names.of(move.tag));
  }
  for (const JogRun& jog : facts.jogs) {
    line(out, "jog", "of {} {}", facts.names.of(jog.started.tag),
         jog.ended ? fmt::format("ended by {} after {} ticks", jog_end_text(jog.ended->how, jog.ended->axis),
                                 jog.ended->taken.value())
                   : "is under way at the end");
  }
  for (const HomingRun& axis : facts.homings) {
    line(out, "homing", "of axis {} {}", axis.started.axis,
         axis.ended ? homing_text(*axis.ended) : std::string{"is under way at the end"});
  }
}

std::string_view verdict(const RunSummary& summary) {
  if (summary.interrupted) return "INTERRUPTED";
  return summary.passed() ? "PASSED" : "FAILED";
}

// The messages of the program, and how it ended. Its lines are in the log.
void add_program(std::string& out, const RunFacts& facts) {
  if (!facts.names.has_program()) return;
  for (const ProgramEvent& event : facts.program_events) {
    if (event.note.kind == ProgramNoted::Kind::kLine) continue;
    line(out, "program", "{} {} ({:.6f} s)", facts.names.line_text(event.note.place), program_note_text(event.note),
         to_seconds(event.at));
  }
  const std::string_view end = facts.program_end();
  if (end == "waiting") line(out, "program", "did not begin");
  if (end == "running") {
    line(out, "program", "is under way at the end, {}", facts.names.line_text(*facts.program_place()));
  }
}

void add_events(std::string& out, const RunFacts& facts) {
  for (const GivenInput& input : facts.inputs) {
    line(out, "input", "{} at {}: {}", input_text(input.spec), moment_text(input.when),
         answer_text(input, facts.names));
  }
  for (const InjectedFault& fault : facts.injected_faults) {
    line(out, "injected fault", "{} at {}:", fault_text(fault.spec), moment_text(fault.when));
    line(out, "", "{}", answer_text(fault));
  }
  for (const FaultEvent& fault : facts.faults) {
    line(out, "fault", "{}{} at {}", word_of(fault.cause),
         fault.where.axis == 0 ? std::string{} : fmt::format(" of axis {}", fault.where.axis),
         moment_text(fault.where));
  }
  for (const BusAbortEvent& abort : facts.bus_aborts) {
    line(out, "bus error", "{} at {}", abort_text(abort), moment_text(abort.where));
  }
  if (const std::string first = first_fault_text(facts); !first.empty()) line(out, "first fault", "{}", first);
  if (facts.controller_silent) {
    line(out, "fault", "the servo enables dropped and the controller did not report it");
  } else if (facts.faults.empty()) {
    line(out, "faults", "none");
  }
  if (!facts.stopped_by.empty()) line(out, "servo enables dropped", "{}", facts.stopped_by);
  for (const RefusedMove& refused : facts.refusals) {
    line(out, refusal_word(refused.refusal.reason), "{} {} ({:.6f} s)", facts.names.of(refused.refusal.tag),
         refusal_text(refused.refusal), to_seconds(refused.at));
  }
}

}  // namespace

std::string verdict_line(const RunSummary& summary) {
  return fmt::format("{} {}: {}\n", verdict(summary), printable(summary.scenario), printable(summary.description));
}

std::string summary_text(const RunSummary& summary) {
  const RunFacts& facts = summary.facts;
  std::string out = verdict_line(summary);
  line(out, "robot", "{}", printable(summary.robot));
  if (summary.variant == Variant::kPaper)
    line(out, "variant", "paper: half periods for counts, one decoder for all encoders");
  line(out, "outcome", "{}", summary.failure ? *summary.failure : std::string{summary.outcome()});
  line(out, "simulated time", "{:.6f} s, {} ticks, {} cycles", facts.simulated_s(), facts.ticks, facts.cycles.value());
  const std::int64_t whole = summary.host.whole_ticks;
  line(out, "host time", "{:.2f} s, {:.2f} Mcycles/s, real-time factor {:.3f}{}", summary.host.wall_s,
       summary.cycles_per_s() / 1e6, summary.real_time_factor(),
       whole > 0 ? fmt::format(", {} ticks as a whole", whole) : std::string{});
  line(out, "bus accesses", "{} reads, {} writes", facts.bus_reads, facts.bus_writes);
  line(out, "worst tick", "{} of {} cycles ({:.1f} %)", facts.worst_tick.value(), kTickCycles,
       100.0 * static_cast<double>(facts.worst_tick.value()) / static_cast<double>(kTickCycles));
  line(out, "moves", "{} started, {} finished, {} refused or dropped{}", facts.moves.size(), facts.moves_finished,
       facts.refusals.size(), unfinished_text(facts));
  add_move_under_way(out, facts);
  out += number_lines(summary);
  if (!facts.serial_sent.empty() || facts.serial_errors > 0) {
    line(out, "serial line", "{} bytes from the controller, {} errors or breaks", facts.serial_sent.size(),
         facts.serial_errors);
  }
  if (summary.serial_unsent > 0) {
    line(out, "serial line", "{} characters or breaks to the controller were not sent before the end",
         summary.serial_unsent);
  }
  for (const OutputChange& change : facts.outputs) {
    line(out, "output", "pin {} = {} at {:.6f} s", change.pin, change.level ? 1 : 0, to_seconds(change.at));
  }
  out += axis_lines(summary) + tool_lines(summary);
  add_moves(out, facts);
  add_program(out, facts);
  if (!summary.program_end.empty()) line(out, "program", "{}", early_end_text(summary.program_end));
  add_events(out, facts);
  if (!facts.sha256.empty()) line(out, "sha256", "{}", facts.sha256);
  if (!summary.golden.text.empty()) line(out, "golden", "{}: {}", summary.golden.word(), summary.golden.text);
  out += summary.golden.details;
  for (const ExpectFailure& failure : summary.expect_failures) line(out, "not met", "{}", failure.text());
  return out;
}

}  // namespace armature::cosim
