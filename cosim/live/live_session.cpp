#include "cosim/live/live_session.hpp"

#include "cosim/live/live_state.hpp"

namespace armature::cosim {

LiveSession::LiveSession(const Scenario& scenario)
    : scenario_{scenario},
      watch_{scenario},
      kinematics_{scenario},
      run_{scenario, {.serial_peer = &pendant_, .sent_bytes = SentBytes::kForgotten}},
      cell_{run_},
      commands_{{.scenario = scenario, .pendant = pendant_, .kinematics = kinematics_, .run = run_, .cell = cell_}} {
  run_.add(watch_);
  run_.add(cell_);
}

std::string LiveSession::state(double factor) {
  const Json state = live_state({.scenario = scenario_,
                                 .pendant = pendant_,
                                 .watch = watch_,
                                 .kinematics = kinematics_,
                                 .cell = cell_,
                                 .program = commands_.program_name(),
                                 .state = run_.look(),
                                 .factor = factor});
  return compact_text(state);
}

std::string LiveSession::on_message(std::string_view text) {
  pendant_.set_operator(true);
  return commands_.answer(text);
}

}  // namespace armature::cosim
