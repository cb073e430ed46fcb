#include "cosim/servo/servo_numbers.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include "controller/base/angle_units.hpp"
#include "cosim/robot/motor_step.hpp"

namespace armature::cosim {
namespace {

constexpr double kWholeTurn = 2.0 * std::numbers::pi;

// exp(-x), x >= 0, in plain arithmetic, because std::exp does not promise the same bits everywhere: a Taylor series of
// x / 1024, squared ten times. Within 1e-12 of the value, and 0 where it is smaller than 1e-13.
double decay(double x) {
  if (x > 30.0) return 0.0;
  const double part = -x / 1024.0;
  double sum = 1.0, term = 1.0;
  for (int k = 1; k < 12; ++k) {
    term *= part / k;
    sum += term;
  }
  for (int i = 0; i < 10; ++i) sum *= sum;
  return sum;
}

std::int32_t whole_steps(double ms, double step_s) {
  return static_cast<std::int32_t>(std::lround(ms * 1e-3 / step_s));
}

// The heat of a drive rises by (x^2 - k) / H in a second, with x times the rated torque. From (4 - k) t2 = (9 - k) t3 =
// H it trips after both times of the robot file, and never below sqrt(k) times the rated torque.
void set_overload(ServoNumbers& numbers, std::size_t i, const DynamicsSpec& spec, double ratio) {
  if (spec.rated_torque_nm == 0) return;
  const double t2 = spec.overload_200_s, t3 = spec.overload_300_s;
  if (!(spec.rated_torque_nm > 0 && t3 > 0 && t2 > t3)) throw std::invalid_argument{"servo: overload times"};
  const double never = (4.0 * t2 - 9.0 * t3) / (t2 - t3), heat_s = (9.0 - never) * t3;
  const double rated = spec.rated_torque_nm * ratio;
  numbers.heating[i] = numbers.step_s / (heat_s * rated * rated);
  numbers.cooling[i] = numbers.step_s * never / heat_s;
}

void set_axis(ServoNumbers& numbers, std::size_t i, const AxisSpec& axis) {
  const DriveSpec& drive = axis.drive;
  if (!axis.dynamics) throw std::invalid_argument{"servo: the motor and the gear are not known"};
  const DynamicsSpec& spec = *axis.dynamics;
  const double h = numbers.step_s, ratio = std::fabs(axis.gear_ratio);
  const double counts = static_cast<double>(kCountsPerLine) * static_cast<double>(axis.encoder_lines);
  const double natural = kWholeTurn * drive.natural_hz;
  const double inertia = spec.rotor_inertia_kg_m2 * ratio * ratio;
  const bool positive = ratio > 0 && counts > 0 && natural > 0 && drive.damping > 0 && drive.inertia_kg_m2 > 0 &&
                        inertia > 0 && drive.max_torque_nm > 0 && drive.max_speed_rpm > 0 && spec.current_hz > 0 &&
                        spec.stiffness_nm_rad > 0;
  if (!positive) throw std::invalid_argument{"servo: a parameter is not positive"};

  numbers.rad_per_count[i] = kWholeTurn / (counts * axis.gear_ratio);
  numbers.lag_kept[i] = spec.smoothing_ms > 0 ? decay(h / (spec.smoothing_ms * 1e-3)) : 0.0;
  numbers.position_gain[i] = natural / (2.0 * drive.damping);
  numbers.feed_forward[i] = spec.feed_forward / h;
  numbers.unseen[i] = 0.5 * std::fabs(numbers.rad_per_count[i]);
  numbers.max_speed[i] = drive.max_speed_rpm / 60.0 * kWholeTurn / ratio;
  numbers.torque_per_speed[i] = 2.0 * drive.damping * natural * drive.inertia_kg_m2 * ratio * ratio;
  numbers.integral_per_step[i] = spec.integral_ms > 0 ? h / (spec.integral_ms * 1e-3) : 0.0;
  numbers.max_torque[i] = drive.max_torque_nm * ratio;
  numbers.current_per_step[i] = 1.0 - decay(kWholeTurn * spec.current_hz * h);

  numbers.speed_per_torque[i] = h / inertia;
  const double viscous = spec.viscous_nm_s * ratio * ratio, shorted = spec.dynamic_brake_nm_s * ratio * ratio;
  numbers.driven_drag[i] = 1.0 / (1.0 + h * viscous / inertia);
  numbers.shorted_drag[i] = 1.0 / (1.0 + h * (viscous + shorted) / inertia);
  numbers.friction[i] = h * spec.coulomb_nm * ratio / inertia;
  numbers.holding[i] = h * spec.brake_nm * ratio / inertia;
  numbers.engage_steps[i] = whole_steps(spec.brake_engage_ms, h);
  numbers.release_steps[i] = whole_steps(spec.brake_release_ms, h);

  numbers.half_play[i] = 0.5 * spec.backlash_deg * kRadPerDeg;
  numbers.stiffness[i] = spec.stiffness_nm_rad;
  numbers.damping[i] = spec.gear_damping_nm_s;
  numbers.bearing[i] = spec.joint_viscous_nm_s;

  set_overload(numbers, i, spec, ratio);

  // The rotor alone, within the backlash, has the least inertia.
  if (numbers.torque_per_speed[i] * numbers.speed_per_torque[i] > kMaxSpeedLoopPerStep) {
    throw std::invalid_argument{"servo: the speed loop is too fast for the integration step"};
  }
}

}  // namespace

ServoNumbers servo_numbers(const PerAxis<AxisSpec>& axes, double step_s) {
  ServoNumbers numbers;
  numbers.step_s = step_s;
  for (std::size_t i = 0; i < kAxes; ++i) set_axis(numbers, i, axes[i]);
  return numbers;
}

}  // namespace armature::cosim
