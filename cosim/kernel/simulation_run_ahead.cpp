// Core 0 ahead of the simulation (cosim/cpu/run_ahead.hpp), where a tick runs as a whole.
#include <algorithm>

#include "cosim/kernel/simulation.hpp"

namespace armature::cosim {

Cycles Simulation::horizon() const {
  const bool program_has_room = program_.busy() && host_.has_room(Source::kProgram);
  if (!ticks_.is_whole() || wave_.is_open() || over_ || program_has_room || !soc_->idle() ||
      processor_->next_access()) {
    return now();
  }
  return std::min({soc_->quiet_until(), ticks_.next_event(), plant_.next_event(), next_action(), end(), until_});
}

bool Simulation::host_must_read() const {
  return host_.has_events();
}

void Simulation::catch_up(Cycles until) {
  soc_->advance(until, StopOn::kAccess);
  core_was_ahead_ = true;
}

// The core waits for the response, if it does not get it here: a pin has changed, or the access ends too late or with
// an error.
RunAhead::Outcome Simulation::try_access(const BusRequest& request, Cycles at, Cycles horizon) {
  if (host_must_read() || ticks_.disturbs(request)) return {};
  core_was_ahead_ = true;
  const auto [response, pins_changed, ends, quiet_until] = soc_->access(request, at, horizon - Cycles{1});
  if (!response || pins_changed || response->error != BusError::kNone) {
    access_ = Processor::Access{.core = 0, .request = request};
    access_since_ = at;
    response_ = response;
    pins_changed_ = pins_changed;
    return {.access = Access::kBegun};
  }
  bus_time_[0] += ends - at;
  if (!check_access(request, *response, ends)) return {.access = Access::kBegun};  // the run is over
  return {Access::kDone, response->data, ends, std::min(horizon, quiet_until)};
}

}  // namespace armature::cosim
