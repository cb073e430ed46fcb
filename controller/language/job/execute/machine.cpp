#include "controller/language/job/execute/machine.hpp"

#include <algorithm>

namespace armature::job {

void Machine::select(std::size_t job, std::uint32_t line) noexcept {
  first_job_ = job;
  first_line_ = line;
}

void Machine::start() noexcept {
  alarm_ = parts_.start(first_job_, first_line_);
  line_noted_ = pause_when_done_ = paused_here_ = timed_wait_ = false;
}

bool Machine::select_line(std::uint32_t line) noexcept {
  if (line > parts_.memory.records_of(parts_.memory.jobs[first_job_]).back().line) return false;
  select(first_job_, line);
  return true;
}

bool Machine::has_line(ProgramPlace place) const noexcept {
  if (job_of(place) >= parts_.memory.job_count) return false;
  const std::span records = parts_.memory.records_of(parts_.memory.jobs[job_of(place)]);
  return std::ranges::any_of(records, [place](const Record& one) { return one.line == line_of(place); });
}

Step Machine::step_here(ProgramPort& port) const noexcept {
  return {port, parts_.flow.records(), parts_.flow.at(), place_of(job(), line())};
}

Program::Progress Machine::step(ProgramPort& port) noexcept {
  timed_wait_ = false;
  if (pause_when_done_) {
    if (!port.done()) return Progress::kWaiting;
    pause_when_done_ = false;
    return Progress::kPaused;
  }
  Step step = step_here(port);
  if (!line_noted_) {
    if (!paused_here_ && port.breakpoint_at(step.place())) {
      if (!port.done()) return Progress::kWaiting;
      paused_here_ = true;
      return Progress::kPaused;
    }
    line_noted_ = true;
    const Op op = step.record().op;
    if (op != Op::kBlank && op != Op::kComment && op != Op::kComm) {
      step.note(ProgramNote::Kind::kLine, instruction_of(op).name);
    }
  }
  if (step.check(alarm_) && parts_.execute(step)) {
    finish_record(step);
    return Progress::kWorking;
  }
  timed_wait_ = step.waits_for_time();
  alarm_ = step.alarm();
  if (alarm_ != Alarm::kNone && alarm_ != Alarm::kUser) {
    const Step failed = step_here(port);
    failed.note(ProgramNote::Kind::kAlarm, instruction_of(failed.record().op).name, text_of_alarm(alarm_));
  }
  return step.progress();
}

void Machine::finish_record(const Step& step) noexcept {
  parts_.advance();
  line_noted_ = false;
  pause_when_done_ = step.pauses_after() || single_step_;
  paused_here_ = pause_when_done_;
}

}  // namespace armature::job
