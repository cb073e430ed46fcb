// Core 0 ahead of the simulation (cosim/cpu/run_ahead.hpp), where a tick runs as a whole.
#include <algorithm>

#include "cosim/kernel/simulation.hpp"

namespace armature::cosim {

// Of everything but the chip.
Cycles Simulation::horizon_of_others() const {
  const bool program_has_room = program_.busy() && host_.has_room(Source::kProgram);
  if (!ticks_.is_whole() || wave_.is_open() || over_ || program_has_room || !soc_->idle() ||
      processor_->next_access()) {
    return now();
  }
  return std::min({ticks_.next_event(), plant_.next_event(), next_action(), end(), until_});
}

Cycles Simulation::horizon() const {
  return std::min(horizon_of_others(), soc_->quiet_until());
}

Cycles Simulation::pass_time(Cycles until) {
  const Cycles others = horizon_of_others();
  if (until >= others) return now();
  core_was_ahead_ = true;
  pins_changed_ = soc_->advance(until, StopOn::kPinChange);
  return pins_changed_ ? now() : std::min(others, soc_->quiet_until());
}

bool Simulation::host_must_read() const {
  return host_.has_events();
}

void Simulation::catch_up(Cycles until) {
  soc_->advance(until, StopOn::kAccess);
  core_was_ahead_ = true;
}

// Whether interrupts have fallen, which wakes no core, and no other output has changed.
bool Simulation::interrupts_fell() const {
  SocOutputs others = soc_->outputs();
  if ((others.irq & ~interrupts_) != 0) return false;
  others.irq = seen_.irq;
  return others == seen_;
}

// The core waits for the response, if it does not get it here: a pin has changed, or the access ends too late or with
// an error.
RunAhead::Outcome Simulation::try_access(const BusRequest& request, Cycles at, Cycles horizon) {
  if (host_must_read() || ticks_.disturbs(request)) return {};
  core_was_ahead_ = true;
  Soc::Progress progress = soc_->access(request, at, horizon - Cycles{1});
  while (progress.pins_changed && !progress.response && interrupts_fell()) {
    on_pins_changed();
    progress = soc_->continue_access(horizon - Cycles{1});
  }
  const auto& [response, pins_changed, ends, quiet_until] = progress;
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
