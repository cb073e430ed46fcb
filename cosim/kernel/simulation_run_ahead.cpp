// Core 0 ahead of the simulation (cosim/cpu/run_ahead.hpp), where a tick runs as a whole.
#include <algorithm>

#include "cosim/kernel/simulation.hpp"

namespace armature::cosim {

// Of everything but the chip.
Cycles Simulation::horizon_of_others() const {
  const bool program_has_room = program_.busy() && host_.has_room(Source::kProgram);
  if (!ticks_.is_whole() || wave_.is_open() || over_ || program_has_room || !soc_->idle() || response_ ||
      processor_->next_access() || !injector_.leaves_cores_alone()) {
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
  seen_.irq = soc_->interrupts();
  interrupts_ = injector_.seen_interrupts(seen_.irq);
  processor_->set_interrupts(interrupts_, now());
}

RunAhead::Outcome Simulation::try_access(const BusRequest& request, TimeAhead& time) {
  if (host_must_read()) [[unlikely]]
    return {};
  const Cycles began = time.now;
  const std::optional<std::uint32_t> data = soc_->access_unnoticed(request, time);
  if (!data) return noticed_access(request, time);
  core_was_ahead_ = true;
  bus_time_[0] += time.now - began;
  return {check_access(request, *data, time.now) ? Access::kDone : Access::kBegun, *data};
}

RunAhead::Outcome Simulation::noticed_access(const BusRequest& request, TimeAhead& time) {
  if (ticks_.disturbs(request)) return {};
  core_was_ahead_ = true;
  const Soc::Progress progress = soc_->access(request, time.now, time.horizon - Cycles{1});
  if (progress.pins_changed || !progress.response || progress.response->error != BusError::kNone) [[unlikely]] {
    return continue_access(progress, request, time);
  }
  return end_access(progress, request, time);
}

// The core waits for the response, if it does not get it here: another pin than an interrupt has changed, or the access
// ends too late or with an error.
RunAhead::Outcome Simulation::continue_access(Soc::Progress progress, const BusRequest& request, TimeAhead& time) {
  while (progress.pins_changed && !progress.response && only_interrupts_fell(seen_, soc_->outputs())) {
    take_fallen_interrupts();
    progress = soc_->continue_access(time.horizon - Cycles{1});
  }
  if (progress.response && !progress.pins_changed && progress.response->error == BusError::kNone) {
    return end_access(progress, request, time);
  }
  if (progress.interrupts_fell) take_fallen_interrupts();
  access_ = Processor::Access{.core = 0, .request = request};
  access_since_ = time.now;
  response_ = progress.response;
  pins_changed_ = progress.pins_changed;
  return {.access = Access::kBegun};
}

RunAhead::Outcome Simulation::end_access(const Soc::Progress& progress, const BusRequest& request, TimeAhead& time) {
  bus_time_[0] += progress.ends - time.now;
  time = {.now = progress.ends, .horizon = std::min(time.horizon, progress.quiet_until)};
  if (progress.interrupts_fell) take_fallen_interrupts();
  const std::uint32_t data = progress.response->data;
  return {check_access(request, data, time.now) ? Access::kDone : Access::kBegun, data};  // kBegun: the run is over
}

}  // namespace armature::cosim
