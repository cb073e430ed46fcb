#include "cosim/run/log_listener.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/basic_file_sink.h>

#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <variant>

#include "cosim/report/format/injection_text.hpp"
#include "cosim/report/format/program_note_text.hpp"
#include "cosim/run/bus_abort_event.hpp"
#include "cosim/scenario/fault_text.hpp"
#include "cosim/scenario/move_text.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {

LogListener::LogListener(const Scenario& scenario, const std::filesystem::path& file)
    : LogListener{scenario, std::make_shared<spdlog::sinks::basic_file_sink_st>(file.string(), true)} {}

LogListener::LogListener(const Scenario& scenario, spdlog::sink_ptr sink)
    : scenario_{scenario}, names_{scenario}, log_{"events", std::move(sink)} {
  log_.set_pattern("%l: %v");
  log_.info("{}: {}", printable(scenario.name), printable(scenario.description));
}

void LogListener::on_row(const TraceRow& row, const IntegerDigest&) {
  if (row.telemetry.state == state_) return;
  state_ = row.telemetry.state;
  log_.info("{} state {}", stamp(Cycles{row.cycle}), word_of(state_));
}

void LogListener::on_action(const ScriptAction& action, const RunPlace& place) {
  std::visit([&](const auto& what) { log(what, place); }, action);
}

void LogListener::on_signal(const Signal& signal, const RunPlace& place) {
  std::visit([&](const auto& what) { log(what, place); }, signal);
}

void LogListener::log(const CommandSpec& command, const RunPlace& place) {
  if (is_queued(command.kind)) return;  // its events are logged
  log_.info("{} move[{}] {}", stamp(place.at), command.index, move_text(command.kind));
}

void LogListener::log(const FaultSpec& fault, const RunPlace& place) {
  log_.warn("{} injected fault: {}, at {}", stamp(place.at), fault_text(fault), moment_text(place));
}

void LogListener::log(const FaultEnd& end, const RunPlace& place) {
  log_.info("{} injected fault ends: {}", stamp(place.at), fault_text(end.fault));
}

void LogListener::log(const InputSpec& input, const RunPlace& place) {
  log_.info("{} input: {}, at {}", stamp(place.at), input_text(input), moment_text(place));
}

void LogListener::log(const StreamStep& step, const RunPlace& place) {
  if (step.point != 0) return;
  const StreamSpec& stream = scenario_.streams[step.stream];
  log_.info("{} stream[{}] begins: {} set-points of {}", stamp(place.at), stream.index, stream.points.size(),
            printable(stream.file_name));
}

void LogListener::log(const OutputLevel& output, const RunPlace& place) {
  log_.info("{} output: pin {} = {}", stamp(place.at), output.pin, output.level ? 1 : 0);
}

void LogListener::log(const ServoEnables& enables, const RunPlace& place) {
  log_.info("{} servo enables of axes 6..1: {:06b}", stamp(place.at), enables.levels);
}

void LogListener::log(const BusAbort& abort, const RunPlace& place) {
  log_.error("{} bus error: {}", stamp(place.at), abort_text(bus_abort_event(abort, place)));
}

void LogListener::log(const PendantStepDone& step, const RunPlace& place) {
  log_.info("{} {}", stamp(place.at), step.text);
}

void LogListener::on_end(const RunSummary& summary) {
  const std::string now = stamp(summary.facts.cycles);
  if (summary.failure) log_.critical("{} {}", now, printable(*summary.failure, kShowAll));
  log_facts(summary.facts);
  if (summary.serial_unsent != 0) {
    log_.warn("{} characters or breaks to the controller were not sent before the end", summary.serial_unsent);
  }
  if (!summary.program_end.empty()) log_.warn("{} {}", now, early_end_text(summary.program_end));
  log_.info("{} end", now);
  log_verdicts(summary);
  log_.flush();
}

void LogListener::log_facts(const RunFacts& facts) {
  for (std::size_t i = 0; i < facts.moves.size(); ++i) {
    if (facts.blended_with_next(i) == false)
      log_.warn("{} was not blended with the next one: the tool stopped at its end", names_.of(facts.moves[i].tag));
  }
  for (const InjectedFault& fault : facts.injected_faults) {
    log_.info("injected fault at {}: {}: {}", moment_text(fault.when), fault_text(fault.spec), answer_text(fault));
  }
  if (const std::string first = first_fault_text(facts); !first.empty()) log_.info("first fault: {}", first);
  for (const GivenInput& input : facts.inputs) {
    log_.info("input at {}: {}: {}", moment_text(input.when), input_text(input.spec), answer_text(input, names_));
  }
  if (facts.moves_waiting != 0 || facts.moves_under_way != 0) {
    log_.warn("{} moves waiting, {} under way at the end", facts.moves_waiting, facts.moves_under_way);
  }
}

void LogListener::log_verdicts(const RunSummary& summary) {
  const GoldenCheck& golden = summary.golden;
  if (golden.verdict == GoldenVerdict::kDiffers) {
    log_.error("golden differs: {}", golden.text);
    std::istringstream details{golden.details + golden.columns};
    for (std::string line; std::getline(details, line);) log_.error("{}", line);
  }
  for (const ExpectFailure& failure : summary.expect_failures) log_.error("not met: {}", failure.text());
}

}  // namespace armature::cosim
