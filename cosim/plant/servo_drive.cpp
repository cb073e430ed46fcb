#include "cosim/plant/servo_drive.hpp"

#include <cmath>

#include "cosim/plant/clock.hpp"

namespace armature::cosim {
namespace {

constexpr double kInPositionCounts = 5.0;
// The normal lag at full speed is 2 zeta / wn * speed: 0.4 revolutions at 3000 rpm, 40 Hz and damping 1.
constexpr double kAlarmErrorRevolutions = 3.0;

std::int32_t counts_per_rev(const AxisSpec& spec) {
  return 4 * spec.encoder_lines;
}

}  // namespace

ServoDrive::ServoDrive(std::size_t axis, const AxisSpec& spec)
    : input_{axis, StepTiming::from(spec.drive)},
      gear_{counts_per_rev(spec), spec.pulses_per_rev},
      loop_{spec.drive, static_cast<double>(counts_per_rev(spec))},
      alarm_error_{kAlarmErrorRevolutions * static_cast<double>(counts_per_rev(spec))} {}

void ServoDrive::on_pins(Cycles now, bool step, bool dir, bool servo_on) {
  if (servo_on != servo_on_) {
    servo_on_ = servo_on;
    stepping_needed_ = true;
    if (servo_on) {
      switch_on();
    } else {
      alarm_ = false;
    }
  }
  const int pulse = input_.update(now, step, dir, servo_on);
  if (pulse != 0) take_pulse(pulse);
}

void ServoDrive::take_pulse(int direction) {
  if (!enabled()) {
    ignored_ += Pulses{direction};
  } else if (to_drop_ > 0) {
    --to_drop_;
    dropped_ += Pulses{direction};
  } else {
    counted_ += Pulses{direction};
    gear_.pulse(direction);
    loop_.shift_reference(direction * gear_.counts_per_pulse());
    stepping_needed_ = true;
  }
}

void ServoDrive::switch_on() {
  const Counts here = nearest_count(position());
  const double error = static_cast<double>(gear_.whole() - here.value()) + gear_.fraction() + loop_.error();
  gear_.set(here.value());
  loop_.set_error(error);
}

void ServoDrive::step() {
  if (enabled()) {
    loop_.step();
    alarm_ = std::fabs(loop_.error()) > alarm_error_;
    in_position_ = !alarm_ && std::fabs(loop_.error()) < kInPositionCounts;
    stepping_needed_ = alarm_ || !loop_.at_rest();
  } else {
    loop_.brake();
    in_position_ = false;
    stepping_needed_ = !loop_.stands();
  }
}

Subcounts ServoDrive::position() const {
  const double offset = gear_.fraction() + loop_.error();
  const double subcounts = std::floor(offset * static_cast<double>(kSubcountsPerCount) + 0.5);
  return Subcounts{gear_.whole() * kSubcountsPerCount + static_cast<std::int64_t>(subcounts)};
}

double ServoDrive::speed() const {
  return loop_.speed() / kPlantStepSeconds;
}

}  // namespace armature::cosim
