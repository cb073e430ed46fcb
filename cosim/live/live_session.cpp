#include "cosim/live/live_session.hpp"

#include <utility>

#include "cosim/live/live_page.hpp"
#include "cosim/live/live_state.hpp"

namespace armature::cosim {
namespace {

std::string text_of_json(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

LiveSession::LiveSession(const Scenario& scenario, std::function<Clock::time_point()> clock)
    : scenario_{scenario},
      clock_{std::move(clock)},
      watch_{scenario},
      kinematics_{scenario},
      run_{scenario, {.serial_peer = &pendant_, .sent_bytes = SentBytes::kForgotten}},
      cell_{run_},
      commands_{
          {.scenario = scenario, .pendant = pendant_, .kinematics = kinematics_, .run = run_, .cell = cell_}} {
  run_.add(watch_);
  run_.add(cell_);
}

bool LiveSession::advance(Cycles until) {
  if (pendant_.has_operator() && clock_() - last_message_ > kPatience) pendant_.set_operator(false);
  return run_.advance(until);
}

std::string LiveSession::state(double factor) {
  return text_of_json(live_state({.scenario = scenario_,
                                  .pendant = pendant_,
                                  .watch = watch_,
                                  .kinematics = kinematics_,
                                  .cell = cell_,
                                  .program = commands_.program_name(),
                                  .state = run_.look(),
                                  .factor = factor}));
}

std::string LiveSession::page() {
  return live_page(scenario_.name);
}

std::string LiveSession::on_opened() {
  return text_of_json({{"hello", live_scenario(scenario_)}});
}

void LiveSession::on_closed() {
  pendant_.set_operator(false);
}

std::string LiveSession::on_message(std::string_view text) {
  last_message_ = clock_();
  pendant_.set_operator(true);
  return commands_.answer(text);
}

}  // namespace armature::cosim
