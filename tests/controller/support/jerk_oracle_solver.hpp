// The interior-point method of the oracle of jerk_oracle.hpp: the law of least duration that keeps all limits.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tests/controller/support/jerk_oracle_law.hpp"
#include "tests/controller/support/jerk_oracle_path.hpp"

namespace armature::test::jerk_oracle {

// |w| <= 1 with w = sum of part[m] x[first + m], divided by the duration of `interval` if that is one.
struct Constraint {
  static constexpr std::size_t kNoInterval = static_cast<std::size_t>(-1);
  std::size_t first = 0;  // 4 unknowns
  std::array<Vector, 4> part{};
  std::size_t interval = kNoInterval;
  double slack = 1.0, dual = 0.0, residual = 0.0, change = 0.0;
  std::array<double, 4> gradient{};
};

class Solver {
 public:
  // Changes the law to that of least duration. It may exceed limits before; then it is slowed down first.
  void minimise(Law& law, std::vector<Constraint> constraints);

 private:
  void add_time(const Law& law, double scale);
  void add_constraint(const Law& law, Constraint& c, double mu);
  void solve_band();
  double step_along(Law& law, double mu, double scale);

  std::vector<Constraint> constraints_;
  // right_ is minus the derivative of what is minimised, band_ its second derivative: the diagonal and those above.
  std::vector<double> right_, step_;
  std::vector<std::array<double, 4>> band_;
};

}  // namespace armature::test::jerk_oracle
