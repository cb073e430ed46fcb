// The limits of a motion at one point of its path, as bounds of its acceleration u and of x, the square of its speed.
//
// A path has a parameter of any length L. A motion along it has the speed v (L/s), x = v^2 and the acceleration u
// (L/s^2). With the derivatives q' and q'' of a quantity q by the parameter,
//   speed of q = q' v,   acceleration of q = q' u + q'' x.
// So every limit of an acceleration is linear in (u, x) for a scalar, and an ellipse for a vector, and every limit of a
// speed is a bound of x. All sets are convex and contain (0, 0): an arm that stands still keeps its limits.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "controller/base/axes.hpp"

namespace armature {

struct LawLimits {
  // |by_accel u + by_square x| <= 1: an acceleration divided by its limit. Both 0: no limit.
  struct Band {
    double by_accel = 0.0;
    double by_square = 0.0;
  };
  // accel2 u^2 + 2 mixed u x + square2 x^2 <= 1: for a vector a = c u + d x these are c.c, c.d and d.d, divided by the
  // square of the limit. All 0: no limit.
  struct Ellipse {
    double accel2 = 0.0;
    double mixed = 0.0;
    double square2 = 0.0;
  };
  // Those of the joints, then those for motions with limited jerk.
  static constexpr std::size_t kJerkBands = 4;
  std::array<Band, kAxes + kJerkBands> bands{};
  std::array<Ellipse, 2> ellipses{};
  // x <= most_square. Must be finite and above 0 where a law is planned.
  double most_square = std::numeric_limits<double>::infinity();

  // The third derivative of q is q' du/dt + 3 q'' v u + q''' v^3. For each of its terms the largest of all quantities,
  // divided by their limits of jerk; all 0: jerk is not limited.
  struct Jerk {
    double by_change = 0.0;     // |q'|
    double by_both = 0.0;       // 3 |q''|
    double by_speed = 0.0;      // |q'''|^(2/3): by_speed x <= 1 keeps the limit
    double usual_square = 0.0;  // about the x that the law has at this point
  };
  Jerk jerk{};
};

// The largest x that each limit permits by itself with any u: at most the largest x that all permit together.
[[nodiscard]] double largest_square(const LawLimits& limits) noexcept;

// Limits half-way or anywhere between two points, `share` = 0..1.
[[nodiscard]] LawLimits between(const LawLimits& first, const LawLimits& second, double share) noexcept;

// Sets the jerk bands for a law whose moving average over `tau_s` is executed (moving_average.hpp): with no more than u
// its change from or to 0 within tau keeps the limit of jerk. As u v is not linear in (u, x), the second term is
// limited by its tangent at `usual_square`. A motion that keeps these bands may exceed the limit a little, where
// several terms are large.
void limit_jerk(LawLimits& limits, double tau_s) noexcept;

// Removes the jerk bands; usual_square is unknown then: below 0, also between this point and another one.
void free_jerk(LawLimits& limits) noexcept;

// The same limits for a motion that is slower by `share`, 0..1: speeds times share, accelerations times share^2.
void slow_down(LawLimits& limits, double share) noexcept;

}  // namespace armature
