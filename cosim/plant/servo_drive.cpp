#include "cosim/plant/servo_drive.hpp"

#include <cmath>

#include "cosim/plant/counts_per_rev.hpp"

namespace armature::cosim {
namespace {

// The normal lag at full speed is 2 zeta / wn * speed: 0.4 revolutions at 3000 rpm, 40 Hz and damping 1.
constexpr double kAlarmErrorRevolutions = 3.0;

}  // namespace

ServoDrive::ServoDrive(std::size_t axis, const AxisSpec& spec, Counts start)
    : input_{axis, StepTiming::from(spec.drive)},
      state_{.gear = {counts_per_rev(spec), spec.pulses_per_rev}},
      alarm_error_{kAlarmErrorRevolutions * static_cast<double>(counts_per_rev(spec))} {
  state_.gear.set(start.value());
}

void ServoDrive::on_pins(Cycles now, bool step, bool dir, bool servo_on, Shaft& shaft) {
  if (servo_on != servo_on_) {
    servo_on_ = servo_on;
    state_.stepping_needed = true;
    if (servo_on) {
      switch_on(shaft);
    } else {
      state_.alarm = trips_ > 0;
    }
  }
  const int pulse = input_.update(now, step, dir, servo_on);
  if (pulse != 0) handle_pulse(pulse, shaft);
}

void ServoDrive::handle_pulse(int direction, Shaft& shaft) {
  if (!enabled()) {
    ignored_ += Pulses{direction};
  } else if (to_drop_ > 0) {
    --to_drop_;
    dropped_ += Pulses{direction};
  } else {
    const int seen = to_double_ > 0 ? 2 * direction : direction;
    if (to_double_ > 0) {
      --to_double_;
      dropped_ -= Pulses{direction};
    }
    shaft.error -= seen * state_.gear.counts_per_pulse();
    state_.gear.pulses(seen);
    state_.counted += Pulses{seen};
    state_.stepping_needed = true;
  }
}

void ServoDrive::trip() {
  ++trips_;
  state_.alarm = true;
  state_.stepping_needed = true;
}

void ServoDrive::repair() {
  if (--trips_ == 0 && !servo_on_) state_.alarm = false;
}

void ServoDrive::skip(std::int64_t count, bool in_position, bool moves) {
  state_.gear.pulses(count);
  state_.counted += Pulses{count};
  state_.in_position = in_position;
  state_.stepping_needed = moves;
}

void ServoDrive::switch_on(Shaft& shaft) {
  const Counts here = nearest_count(position(shaft));
  const double error = static_cast<double>(gear().whole() - here.value()) + gear().fraction() + shaft.error;
  state_.gear.set(here.value());
  shaft.error = error;
}

MotorDemand ServoDrive::demand() const {
  return {.controlled = enabled(), .reference = static_cast<double>(gear().whole()) + gear().fraction()};
}

void ServoDrive::observe(const Shaft& shaft, bool overloaded) {
  if (enabled()) {
    state_.alarm = overloaded || std::fabs(shaft.error) > alarm_error_;
    state_.in_position = !state_.alarm && std::fabs(shaft.error) < kInPositionCounts;
    state_.stepping_needed = state_.alarm || !shaft.at_rest();
  } else {
    state_.in_position = false;
    state_.stepping_needed = !shaft.stands();
  }
}

}  // namespace armature::cosim
