#include "tests/controller/support/jerk_oracle_solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace armature::test::jerk_oracle {
namespace {

// The duration of an interval and its first two derivatives by b at its ends.
struct Duration {
  double value, first[2], second[3];
};
Duration duration(const Law& law, std::size_t k) {
  const double v0 = law.v(k), v1 = law.v(k + 1), v = v0 + v1, w = law.weight(k);
  Duration d{w / v, {}, {}};
  if (v0 > 0.0) d.first[0] = -0.5 * w / (v * v * v0);
  if (v1 > 0.0) d.first[1] = -0.5 * w / (v * v * v1);
  if (v0 > 0.0) d.second[0] = 0.5 * w / (v * v * v0 * v0) * (1.0 / v + 0.5 / v0);
  if (v1 > 0.0) d.second[2] = 0.5 * w / (v * v * v1 * v1) * (1.0 / v + 0.5 / v1);
  if (v0 > 0.0 && v1 > 0.0) d.second[1] = 0.5 * w / (v * v * v * v0 * v1);
  return d;
}
// The derivatives of b at both ends of an interval by the unknowns from k - 1 on.
std::array<std::array<double, 4>, 2> squares(const Law& law, std::size_t k) {
  std::array<std::array<double, 4>, 2> by{};
  if (k > 0) {
    const Law::Node node = law.node(k);
    for (std::size_t m = 1; m < 4; ++m) by[0][m - 1] = node.b[m];
  }
  if (k + 1 < law.intervals()) by[1] = law.node(k + 1).b;
  return by;
}

struct Value {
  Vector w = Vector::Zero();
  std::array<Vector, 4> by{};
};
Value value_of(const Law& law, const Constraint& c) {
  Value value{.by = c.part};
  for (std::size_t m = 0; m < 4; ++m) {
    if (c.first + m < law.intervals()) value.w += c.part[m] * law.x(c.first + m);
  }
  if (c.interval == Constraint::kNoInterval) return value;
  const Duration d = duration(law, c.interval);
  const auto by = squares(law, c.interval);
  value.w /= d.value;
  for (std::size_t m = 0; m < 4; ++m) {
    const double slower = d.first[0] * by[0][m] + d.first[1] * by[1][m];
    value.by[m] = (value.by[m] - value.w * slower) / d.value;
  }
  return value;
}

}  // namespace

// A primal-dual interior-point method that keeps all limits at each step.
void Solver::minimise(Law& law, std::vector<Constraint> constraints) {
  const std::size_t n = law.intervals();
  constraints_ = std::move(constraints);
  law.update();
  double slower = 1e30;
  for (const Constraint& c : constraints_) {
    const double size = value_of(law, c).w.norm();
    const double power = c.interval == Constraint::kNoInterval ? -1.0 : -2.0 / 3.0;
    if (size > 0.0) slower = std::min(slower, std::pow(size, power));
  }
  for (std::size_t k = 1; k + 1 < n; ++k) law.x(k) *= 0.9 * slower;
  law.update();
  const double scale = 1.0 / law.time();
  const auto count = static_cast<double>(constraints_.size());
  double gap = 1.0;  // the sum of slack times dual at the end of this step
  for (Constraint& c : constraints_) {
    c.slack = 1.0 - value_of(law, c).w.squaredNorm();
    c.dual = gap / (count * c.slack);
  }
  constexpr int kMost = 200;
  constexpr double kGap = 3e-4;
  for (int i = 0; i < kMost; ++i) {
    const double mu = gap / count;
    right_.assign(n, 0.0);
    band_.assign(n, {});
    add_time(law, scale);
    for (Constraint& c : constraints_) add_constraint(law, c, mu);
    solve_band();
    const double length = step_along(law, mu, scale);
    if (length > 0.9 && gap < kGap * scale * law.time()) break;
    // Where the way to the bounds is short, the middle between them comes first.
    gap *= length > 0.9 ? 0.1 : length > 0.5 ? 0.3 : length > 0.2 ? 0.8 : 1.5;
    gap = std::max(gap, 0.3 * kGap * scale * law.time());
  }
}

void Solver::add_time(const Law& law, double scale) {
  for (std::size_t k = 0; k < law.intervals(); ++k) {
    const Duration d = duration(law, k);
    const auto by = squares(law, k);
    for (std::size_t m = 0; m < 4; ++m) {
      const double p = by[0][m], q = by[1][m];
      if (p == 0.0 && q == 0.0) continue;
      right_[k + m - 1] -= scale * (d.first[0] * p + d.first[1] * q);
      for (std::size_t o = m; o < 4; ++o) {
        const double r = by[0][o], t = by[1][o];
        if (r == 0.0 && t == 0.0) continue;
        band_[k + m - 1][o - m] += scale * (d.second[0] * p * r + d.second[1] * (p * t + q * r) + d.second[2] * q * t);
      }
    }
  }
}
void Solver::add_constraint(const Law& law, Constraint& c, double mu) {
  const Value value = value_of(law, c);
  c.residual = value.w.squaredNorm() - 1.0 + c.slack;
  const double ratio = c.dual / c.slack, push = mu / c.slack + ratio * c.residual;
  for (std::size_t m = 0; m < 4; ++m) c.gradient[m] = 2.0 * value.w.dot(value.by[m]);
  for (std::size_t m = 0; m < 4; ++m) {
    const std::size_t at = c.first + m;
    if (at == 0 || at + 1 >= law.intervals()) continue;
    right_[at] -= push * c.gradient[m];
    for (std::size_t o = m; o < 4; ++o) {
      if (at + o - m + 1 >= law.intervals()) continue;
      band_[at][o - m] += 2.0 * c.dual * value.by[m].dot(value.by[o]) + ratio * c.gradient[m] * c.gradient[o];
    }
  }
}
// Gauss' method for seven diagonals, without the ends.
void Solver::solve_band() {
  const std::size_t n = band_.size();
  step_ = right_;
  step_[0] = step_[n - 1] = 0.0;
  for (std::size_t p = 1; p + 1 < n; ++p) {
    for (std::size_t m = 1; m < 4 && p + m + 1 < n; ++m) {
      const double share = band_[p][m] / band_[p][0];
      for (std::size_t y = m; y < 4 && p + y + 1 < n; ++y) band_[p + m][y - m] -= share * band_[p][y];
      step_[p + m] -= share * step_[p];
    }
  }
  for (std::size_t p = n - 1; p-- > 1;) {
    for (std::size_t m = 1; m < 4 && p + m + 1 < n; ++m) step_[p] -= band_[p][m] * step_[p + m];
    step_[p] /= band_[p][0];
  }
}

// Moves along the step as far as all limits are kept and the barrier function falls; the duals too. Returns the
// share.
double Solver::step_along(Law& law, double mu, double scale) {
  constexpr double kToBound = 0.95;
  double share = 1.0, dual = 1.0;
  for (Constraint& c : constraints_) {
    double slack = -c.residual;
    for (std::size_t m = 0; m < 4; ++m) {
      if (c.first + m < law.intervals()) slack -= c.gradient[m] * step_[c.first + m];
    }
    c.change = mu / c.slack - c.dual - c.dual / c.slack * slack;
    if (c.change < 0.0) dual = std::min(dual, kToBound * c.dual / -c.change);
  }
  const auto barrier = [&](const Law& at) {
    if (!at.moves()) return 1e300;
    double sum = scale * at.time();
    for (const Constraint& c : constraints_) {
      const double slack = 1.0 - value_of(at, c).w.squaredNorm();
      if (!(slack > (1.0 - kToBound) * c.slack)) return 1e300;
      sum -= mu * std::log(slack);
    }
    return sum;
  };
  const double before = barrier(law);
  Law moved = law;
  for (int i = 0;; ++i) {
    if (i == 30) return 0.0;
    for (std::size_t k = 1; k + 1 < law.intervals(); ++k) moved.x(k) = law.x(k) + share * step_[k];
    moved.update();
    if (barrier(moved) <= before + 1e-12) break;
    share *= 0.6;
  }
  law = moved;
  for (Constraint& c : constraints_) {
    c.slack = 1.0 - value_of(law, c).w.squaredNorm();
    c.dual = std::clamp(c.dual + dual * c.change, 0.01 * mu / c.slack, 100.0 * mu / c.slack);
  }
  return share;
}

}  // namespace armature::test::jerk_oracle
