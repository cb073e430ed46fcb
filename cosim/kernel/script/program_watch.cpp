#include "cosim/kernel/script/program_watch.hpp"

#include <algorithm>

#include "cosim/text/names.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

// Of everything that the scenario does to the system.
Cycles last_action_of(const Scenario& scenario, const Script& script) {
  const Cycles sent = scenario.serial_sends.empty() ? Cycles{} : to_cycles(scenario.serial_sends.back().at_s);
  return std::max(sent, script.last_event());
}

}  // namespace

ProgramWatch::ProgramWatch(const Scenario& scenario, const Script& script)
    : judged_{scenario.program && !scenario.pendant},
      ends_with_program_{scenario.ends_with_program},
      pauses_end_{scenario.program_resumes_after_s.has_value()},
      expected_{scenario.expect.program_end.value_or(std::string{word_of(ProgramNoted::Kind::kEnded)})},
      last_action_{last_action_of(scenario, script)} {}

void ProgramWatch::on_note(const ProgramNoted& note, Cycles now) {
  using enum ProgramNoted::Kind;
  if (!judged_) return;
  if (note.kind == kAlarm || note.kind == kStopped) failed_ = word_of(note.kind);
  if (note.kind == kOver) over(failed_, now);
  if (note.kind == kEnded || (note.kind == kPaused && !pauses_end_)) over(word_of(note.kind), now);
}

void ProgramWatch::over(std::string_view how, Cycles now) {
  const Cycles rest = to_cycles(kRestS);
  if (how != expected_) {
    unexpected_ = how;
    end_ = now + rest;
  } else if (ends_with_program_) {
    end_ = std::max(now, last_action_) + rest;
  }
}

}  // namespace armature::cosim
