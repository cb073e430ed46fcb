// A run that a page shows and drives: the simulation, its pendant, and what the page is told. What it does depends on
// the messages and on the cycles at which they come, and on nothing else: the session can be repeated. It reads no
// clock.
//
// What reached the pendant's line is in the run's serial log, so the run can be repeated without the page, too.
#pragma once

#include <string>
#include <string_view>

#include "cosim/live/live_cell.hpp"
#include "cosim/live/live_kinematics.hpp"
#include "cosim/live/live_pendant.hpp"
#include "cosim/live/live_watch.hpp"
#include "cosim/live/page_commands.hpp"
#include "cosim/run/run.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

class LiveSession {
 public:
  // The scenario has [pendant] and [serial] and outlives the session.
  explicit LiveSession(const Scenario& scenario);
  LiveSession(const LiveSession&) = delete;
  LiveSession& operator=(const LiveSession&) = delete;

  // For listeners, before the first advance().
  [[nodiscard]] Run& run() { return run_; }
  [[nodiscard]] const LiveCell& cell() const { return cell_; }
  [[nodiscard]] Cycles now() const { return run_.now(); }

  // Continues up to this cycle. False when the run is over.
  bool advance(Cycles until) { return run_.advance(until); }
  // The state for the page, as JSON. `factor`: simulated time per real time, lately.
  [[nodiscard]] std::string state(double factor);
  // A message of the page, which is there: its operator sees the arm. Returns the answer; empty: none.
  [[nodiscard]] std::string on_message(std::string_view text);
  // A message that is a question: it changes nothing, not even whether somebody is there.
  [[nodiscard]] std::string on_question(std::string_view text) { return commands_.answer(text); }
  // Nobody is at the page.
  void on_closed() { pendant_.set_operator(false); }

 private:
  const Scenario& scenario_;
  LiveWatch watch_;
  LivePendant pendant_;
  LiveKinematics kinematics_;
  Run run_;
  LiveCell cell_;
  PageCommands commands_;
};

}  // namespace armature::cosim
