// Decides when a run ends because its program is over: at the end of a run without `duration_s`, and as soon as a
// program has ended in another way than the scenario expects, because what follows shows nothing.
//
// A program is over when it has ended, has failed and the arm does nothing more of it, or is paused and nobody lets it
// continue. With a pendant it never is: the operator may run it again.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "controller/message/program_noted.hpp"
#include "cosim/kernel/script/script.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

class ProgramWatch {
 public:
  // Simulated time after the end, in which the axes settle and the last pulses arrive.
  static constexpr double kRestS = 0.1;

  // `script` has all its actions.
  ProgramWatch(const Scenario& scenario, const Script& script);

  void on_note(const ProgramNoted& note, Cycles now);

  // When the run ends; none: not because of its program, or this is not known yet. Never later than at duration_s.
  [[nodiscard]] std::optional<Cycles> end() const { return end_; }
  // With end(): how the program ended, if the scenario does not expect that.
  [[nodiscard]] std::string_view unexpected() const { return unexpected_; }

 private:
  void over(std::string_view how, Cycles now);

  bool judged_;             // the end of the program can end the run
  bool ends_with_program_;  // and an expected one does so, too
  bool pauses_end_;         // by themselves
  std::string expected_;
  Cycles last_action_;  // of the scenario
  std::string_view failed_;
  std::optional<Cycles> end_;
  std::string_view unexpected_;
};

}  // namespace armature::cosim
