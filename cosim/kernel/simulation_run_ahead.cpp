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

// Interrupts have fallen, and no other output has changed.
void Simulation::take_fallen_interrupts() {
  seen_.irq = interrupts_ = soc_->interrupts();
  processor_->set_interrupts(interrupts_, now());
}

RunAhead::Outcome Simulation::try_access(const BusRequest& request, Cycles at, Cycles horizon) {
  if (host_must_read() || ticks_.disturbs(request)) return {};
  core_was_ahead_ = true;
  const Soc::Progress progress = soc_->access(request, at, horizon - Cycles{1});
  if (progress.pins_changed || !progress.response || progress.response->error != BusError::kNone) [[unlikely]] {
    return continue_access(progress, request, at, horizon);
  }
  return end_access(progress, request, at, horizon);
}

// The core waits for the response, if it does not get it here: another pin than an interrupt has changed, or the access
// ends too late or with an error.
RunAhead::Outcome Simulation::continue_access(Soc::Progress progress, const BusRequest& request, Cycles at,
                                              Cycles horizon) {
  while (progress.pins_changed && !progress.response && only_interrupts_fell(seen_, soc_->outputs())) {
    take_fallen_interrupts();
    progress = soc_->continue_access(horizon - Cycles{1});
  }
  if (progress.response && !progress.pins_changed && progress.response->error == BusError::kNone) {
    return end_access(progress, request, at, horizon);
  }
  if (progress.interrupts_fell) take_fallen_interrupts();
  access_ = Processor::Access{.core = 0, .request = request};
  access_since_ = at;
  response_ = progress.response;
  pins_changed_ = progress.pins_changed;
  return {.access = Access::kBegun};
}

RunAhead::Outcome Simulation::end_access(const Soc::Progress& progress, const BusRequest& request, Cycles at,
                                         Cycles horizon) {
  bus_time_[0] += progress.ends - at;
  if (progress.interrupts_fell) take_fallen_interrupts();
  if (!check_access(request, *progress.response, progress.ends)) return {.access = Access::kBegun};  // the run is over
  return {Access::kDone, progress.response->data, progress.ends, std::min(horizon, progress.quiet_until)};
}

}  // namespace armature::cosim
