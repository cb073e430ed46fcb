#include "cosim/plant/position_loop.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cosim/plant/clock.hpp"

namespace armature::cosim {
namespace {

constexpr double kTwoPi = 6.283185307179586476925;

struct Matrix {
  double a, b, c, d;  // [a b; c d]
};

constexpr Matrix multiply(const Matrix& p, const Matrix& q) {
  return {p.a * q.a + p.b * q.c, p.a * q.b + p.b * q.d, p.c * q.a + p.d * q.c, p.c * q.b + p.d * q.d};
}

// Matrix exponential by its Taylor series, in plain arithmetic so that every machine gets the same bits (std::exp does
// not promise that). For norms up to 2, 24 terms leave less than 2^24/24! = 3e-17.
Matrix exponential(const Matrix& m) {
  Matrix sum{1, 0, 0, 1};
  Matrix term = sum;
  for (int k = 1; k < 24; ++k) {
    term = multiply(term, m);
    const double inverse = 1.0 / k;
    term = {term.a * inverse, term.b * inverse, term.c * inverse, term.d * inverse};
    sum = {sum.a + term.a, sum.b + term.b, sum.c + term.c, sum.d + term.d};
  }
  return sum;
}

}  // namespace

PositionLoop::PositionLoop(const DriveSpec& spec, double counts_per_rev) {
  const double wn_h = kTwoPi * spec.natural_hz * kPlantStepSeconds;
  const bool positive = spec.natural_hz > 0 && spec.damping > 0 && spec.max_speed_rpm > 0 && spec.max_torque_nm > 0 &&
                        spec.inertia_kg_m2 > 0 && counts_per_rev > 0;
  if (!positive) throw std::invalid_argument{"servo drive: a parameter is not positive"};
  if (wn_h > 0.5 || 2.0 * spec.damping * wn_h > 1.0) {
    throw std::invalid_argument{"servo drive: the position loop is too fast for the integration step"};
  }
  stiffness_ = wn_h * wn_h;
  drag_ = 2.0 * spec.damping * wn_h;
  const double rad_s2 = spec.max_torque_nm / spec.inertia_kg_m2;
  const Matrix phi = exponential({0.0, 1.0, -stiffness_, -drag_});
  numbers_ = {.error_by_error = phi.a,
              .error_by_speed = phi.b,
              .speed_by_error = phi.c,
              .speed_by_speed = phi.d,
              .max_accel = rad_s2 / kTwoPi * counts_per_rev * (kPlantStepSeconds * kPlantStepSeconds),
              .max_speed = spec.max_speed_rpm / 60.0 * counts_per_rev * kPlantStepSeconds,
              .rest_speed = kRestCounts * wn_h};
}

void PositionLoop::step(Shaft& shaft) const {
  if (shaft.at_rest()) return;
  const double error = numbers_.error_by_error * shaft.error + numbers_.error_by_speed * shaft.speed;
  const double speed = numbers_.speed_by_error * shaft.error + numbers_.speed_by_speed * shaft.speed;
  if (std::fabs(speed - shaft.speed) <= numbers_.max_accel && std::fabs(speed) <= numbers_.max_speed) {
    shaft.error = error;
    shaft.speed = speed;
    settle(shaft);
  } else {
    move_with(-stiffness_ * shaft.error - drag_ * shaft.speed, shaft);
  }
}

void PositionLoop::brake(Shaft& shaft) const {
  move_with(-shaft.speed, shaft);
}

void PositionLoop::move_with(double accel, Shaft& shaft) const {
  const double limited = std::clamp(accel, -numbers_.max_accel, numbers_.max_accel);
  const double speed = std::clamp(shaft.speed + limited, -numbers_.max_speed, numbers_.max_speed);
  shaft.error += 0.5 * (shaft.speed + speed);
  shaft.speed = speed;
}

void PositionLoop::settle(Shaft& shaft) const {
  if (std::fabs(shaft.error) < kRestCounts && std::fabs(shaft.speed) < numbers_.rest_speed) {
    shaft.error = shaft.speed = 0.0;
  }
}

}  // namespace armature::cosim
