// One step of a program: the record that is executed, the port to its surroundings, and how the step ends.
//
// A function that cannot finish returns what one of the ends here returns: false. Whoever called it returns false, too.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "controller/language/job/memory/program_memory.hpp"
#include "controller/language/job/state/alarm.hpp"
#include "controller/language/program/program.hpp"

namespace armature::job {

class Step {
 public:
  using Progress = Program::Progress;

  // `at` is the record to execute, among those of its job.
  Step(ProgramPort& port, std::span<const Record> records, std::uint16_t at, ProgramPlace place) noexcept
      : port_{port}, records_{records}, at_{at}, place_{place} {}

  [[nodiscard]] const Record& record() const noexcept { return records_[at_]; }
  // Another one of the job.
  [[nodiscard]] const Record& record(std::uint16_t at) const noexcept { return records_[at]; }
  [[nodiscard]] std::uint16_t at() const noexcept { return at_; }
  [[nodiscard]] ProgramPlace place() const noexcept { return place_; }

  [[nodiscard]] ProgramPort& port() const noexcept { return port_; }
  void send(const Command& command) const noexcept { port_.send(command, place_); }
  void note(ProgramNote::Kind kind, std::string_view first = {}, std::string_view second = {}) const noexcept {
    ProgramNote note{.kind = kind, .place = place_, .text = first};
    if (!second.empty()) note.text << ": " << second;
    port_.note(note);
  }

  // Ends of a step before its record is executed.
  [[nodiscard]] bool fail(Alarm alarm) noexcept {
    alarm_ = alarm;
    return end_as(Progress::kAlarm);
  }
  [[nodiscard]] bool check(Alarm alarm) noexcept { return alarm == Alarm::kNone || fail(alarm); }
  [[nodiscard]] bool wait() noexcept { return end_as(Progress::kWaiting); }
  // For an input or for time, which must be looked at in each tick.
  [[nodiscard]] bool wait_in_each_tick() noexcept {
    timed_wait_ = true;
    return wait();
  }
  [[nodiscard]] bool wait_for_room() noexcept { return port_.has_room() || wait(); }
  [[nodiscard]] bool wait_until_done() noexcept { return port_.done() || wait(); }
  [[nodiscard]] bool end_program() noexcept { return end_as(Progress::kEnded); }

  // The program pauses when this record is executed and the arm stands.
  void pause_after() noexcept { pauses_after_ = true; }

  [[nodiscard]] Progress progress() const noexcept { return progress_; }
  [[nodiscard]] Alarm alarm() const noexcept { return alarm_; }
  [[nodiscard]] bool waits_for_time() const noexcept { return timed_wait_; }
  [[nodiscard]] bool pauses_after() const noexcept { return pauses_after_; }

 private:
  [[nodiscard]] bool end_as(Progress progress) noexcept {
    progress_ = progress;
    return false;
  }

  ProgramPort& port_;
  std::span<const Record> records_;
  std::uint16_t at_;
  ProgramPlace place_;
  Progress progress_ = Progress::kWorking;
  Alarm alarm_ = Alarm::kNone;
  bool timed_wait_ = false;
  bool pauses_after_ = false;
};

}  // namespace armature::job
