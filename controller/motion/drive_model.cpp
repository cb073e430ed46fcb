#include "controller/motion/drive_model.hpp"

#include <cmath>

#include "controller/base/timebase.hpp"

namespace armature {
namespace {

struct Matrix {
  double a, b, c, d;  // [a b; c d]
};

constexpr Matrix operator*(const Matrix& p, const Matrix& q) {
  return {p.a * q.a + p.b * q.c, p.a * q.b + p.b * q.d, p.c * q.a + p.d * q.c, p.c * q.b + p.d * q.d};
}

// The simulated drives (cosim/plant) integrate the same equation with separate code, on purpose. If the controller
// shared code with the model that tests it, one mistake could hide in both.
//
// Taylor series after halving the argument to a norm below 1/2, then squaring back: full double accuracy in plain
// arithmetic, so every machine gets the same bits.
Matrix exponential(Matrix m) {
  int halvings = 0;
  while (std::fabs(m.a) + std::fabs(m.b) + std::fabs(m.c) + std::fabs(m.d) > 0.5) {
    m = {0.5 * m.a, 0.5 * m.b, 0.5 * m.c, 0.5 * m.d};
    ++halvings;
  }
  Matrix sum{1.0, 0.0, 0.0, 1.0};
  Matrix term = sum;
  for (int k = 1; k <= 16; ++k) {  // 2^-16 / 16! < 1e-18
    term = term * m;
    term = {term.a / k, term.b / k, term.c / k, term.d / k};
    sum = {sum.a + term.a, sum.b + term.b, sum.c + term.c, sum.d + term.d};
  }
  for (; halvings > 0; --halvings) sum = sum * sum;
  return sum;
}

}  // namespace

DriveModel::DriveModel(double natural_rad_s, double damping) noexcept {
  const double wn = natural_rad_s * kTickSeconds;  // per tick
  ramp_lag_ticks_ = 2.0 * damping / wn;
  // Equal scaling of position and speed ([0 wn; -wn -2 zeta wn]) keeps the norm, and so the computation, small for slow
  // drives.
  const Matrix phi = exponential({0.0, wn, -wn, -2.0 * damping * wn});
  phi_xx_ = phi.a;
  phi_xv_ = phi.b / wn;
  phi_vx_ = phi.c * wn;
  phi_vv_ = phi.d;
}

void DriveModel::restart(Pulses sent) noexcept {
  sent_ = sent;
  lag_ = 0.0;
  speed_ = 0.0;
}

void DriveModel::subtract(Pulses count) noexcept {
  sent_ -= count;
  lag_ -= static_cast<double>(count.value());
}

}  // namespace armature
