#include "cosim/plant/servo_drive.hpp"

#include <cmath>

#include "cosim/plant/counts_per_rev.hpp"

namespace armature::cosim {
namespace {

constexpr double kInPositionCounts = 5.0;
// The normal lag at full speed is 2 zeta / wn * speed: 0.4 revolutions at 3000 rpm, 40 Hz and damping 1.
constexpr double kAlarmErrorRevolutions = 3.0;

}  // namespace

ServoDrive::ServoDrive(std::size_t axis, const AxisSpec& spec, Counts start)
    : input_{axis, StepTiming::from(spec.drive)},
      gear_{counts_per_rev(spec), spec.pulses_per_rev},
      alarm_error_{kAlarmErrorRevolutions * static_cast<double>(counts_per_rev(spec))} {
  gear_.set(start.value());
}

void ServoDrive::on_pins(Cycles now, bool step, bool dir, bool servo_on, Shaft& shaft) {
  if (servo_on != servo_on_) {
    servo_on_ = servo_on;
    stepping_needed_ = true;
    if (servo_on) {
      switch_on(shaft);
    } else {
      alarm_ = false;
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
    take(direction, shaft);
  }
}

// The same sums, in the same order, as pulse by pulse.
void ServoDrive::take(std::int32_t count, Shaft& shaft) {
  const double step = (count < 0 ? -1 : +1) * gear_.counts_per_pulse();
  for (std::int32_t i = count < 0 ? -count : count; i > 0; --i) shaft.error -= step;
  counted_ += Pulses{count};
  gear_.pulses(count);
  stepping_needed_ = true;
}

void ServoDrive::switch_on(Shaft& shaft) {
  const Counts here = nearest_count(position(shaft));
  const double error = static_cast<double>(gear_.whole() - here.value()) + gear_.fraction() + shaft.error;
  gear_.set(here.value());
  shaft.error = error;
}

MotorDemand ServoDrive::demand() const {
  return {.controlled = enabled(), .reference = static_cast<double>(gear_.whole()) + gear_.fraction()};
}

void ServoDrive::observe(const Shaft& shaft) {
  if (enabled()) {
    alarm_ = std::fabs(shaft.error) > alarm_error_;
    in_position_ = !alarm_ && std::fabs(shaft.error) < kInPositionCounts;
    stepping_needed_ = alarm_ || !shaft.at_rest();
  } else {
    in_position_ = false;
    stepping_needed_ = !shaft.stands();
  }
}

Subcounts ServoDrive::position(const Shaft& shaft) const {
  const double offset = gear_.fraction() + shaft.error;
  const double subcounts = std::floor(offset * static_cast<double>(kSubcountsPerCount) + 0.5);
  return Subcounts{gear_.whole() * kSubcountsPerCount + static_cast<std::int64_t>(subcounts)};
}

}  // namespace armature::cosim
