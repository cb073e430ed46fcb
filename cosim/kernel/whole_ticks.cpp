#include "cosim/kernel/whole_ticks.hpp"

#include <algorithm>
#include <utility>

namespace armature::cosim {

WholeTicks::WholeTicks(Soc& soc, Plant& plant, Conservation& conservation)
    : soc_{soc}, port_{soc.motion_port()}, plant_{plant}, conservation_{conservation} {}

bool WholeTicks::on_trigger(Cycles now) {
  if (port_ == nullptr) return false;
  bool changed = false;
  if (tick_ && now + Cycles{1} == tick_->ends) {
    port_->finish(*tick_);
    conservation_.on_tick(*tick_);
    over_ = true;
    ++ticks_;
  } else {
    changed = leave(now);
  }
  next_event_ = now + Cycles{1};
  return changed;
}

bool WholeTicks::advance(Cycles now, bool allowed) {
  if (now < next_event_) return false;
  next_event_ = kNever;
  if (tick_ && !over_) return leave(now);  // the trigger is late
  if (allowed && soc_.motion_port() != nullptr && begin(now)) {
    next_event_ = tick_->ends - Cycles{1};
    return false;
  }
  if (!plant_.leaves_out_edges()) return false;
  continue_after(now, true);
  return true;
}

// The tick that has begun at this edge. Returns whether it runs as a whole.
bool WholeTicks::begin(Cycles now) {
  const bool first = !plant_.leaves_out_edges();
  over_ = false;
  tick_ = port_->begin();
  const auto times = port_->decoder_times();
  const bool fits =
      tick_ && (tick_->ends - tick_->begins).value() > 2 * times.history.value() && times.history < kPlantStep;
  if (!fits || (first && now <= times.history)) {
    tick_.reset();
    return false;
  }
  LineHistory history;
  if (first) history = plant_.line_history(now - times.history, now);
  if (plant_.begin_tick(*tick_, times.latency)) {
    const bool left_out = !first || port_->leave_out(history);
    if (left_out && expect_trigger()) return true;
    plant_.revert_tick();
    if (first && left_out) continue_after(now, true);
  }
  tick_.reset();
  return false;
}

bool WholeTicks::expect_trigger() {
  const Cycles shown = tick_->ends - Cycles{1} - port_->decoder_times().latency;
  PerAxis<Counts> counts;
  for (std::size_t axis = 0; axis < kAxes; ++axis) counts[axis] = plant_.count_after(axis, shown);
  return port_->expect(counts, plant_.index_in_tick());
}

bool WholeTicks::leave(Cycles now) {
  if (!tick_) return false;
  const TickPulses tick = *tick_;
  tick_.reset();
  next_event_ = over_ ? now + Cycles{1} : kNever;
  if (std::exchange(over_, false)) {
    continue_after(now, false);
    return true;
  }
  plant_.revert_tick();
  continue_after(tick.begins, true);
  if (plant_.next_event() <= tick.begins) plant_.advance(tick.begins);
  for (Cycles at = tick.begins; at < now;) {
    const Cycles next = std::clamp(plant_.next_event(), at + Cycles{1}, now);
    const SocInputs& in = plant_.inputs();
    at = port_->catch_up(at, next, {.a = in.enc_a, .b = in.enc_b, .z = in.enc_z});
    plant_.on_outputs(at, soc_.outputs());
    conservation_.on_outputs(at, soc_.outputs());
    if (plant_.next_event() <= at) plant_.advance(at);
  }
  return true;
}

// After the edge `at`: a tick has begun, or (not `begun`) is over with the coming edge.
void WholeTicks::continue_after(Cycles at, bool begun) {
  const LineHistory history = plant_.line_history(at - port_->decoder_times().history, at);
  port_->continue_after(at, history, begun);
  const MotionPort::StepPins pins = port_->step_pins();
  plant_.resume_edges(begun ? at - Cycles{1} : at, soc_.outputs(), pins.changed, pins.turned);
}

}  // namespace armature::cosim
