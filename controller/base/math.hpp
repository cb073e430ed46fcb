// The transcendental functions of the controller. They return the same bits on every machine, compiler and libm,
// because they use plain IEEE double arithmetic without contraction. (glibc selects FMA variants by machine, and the
// ARM's libm differs again.)
//
// Error of each: at most 1 ulp. Largest seen against MPFR (tests/controller/base/math_test.cpp and denser sweeps,
// millions of arguments): sin, cos and sin_cos 0.80 ulp, atan2 0.56 ulp, cbrt and hypot 0.50 ulp, hypot 0.75 ulp where
// its result is subnormal. Odd and even symmetry hold bit for bit. Requires rounding to nearest. sqrt, floor, fabs
// and fmod have one right result, which every machine gives: they come from <cmath>.
#pragma once

#include <span>

namespace armature::math {

struct SinCos {
  double sin = 0.0;
  double cos = 1.0;
};

// x in radians, |x| <= 1e6 (a joint that has made 160 000 turns); beyond that, and for a NaN, the result is NaN.
[[nodiscard]] double sin(double x) noexcept;
[[nodiscard]] double cos(double x) noexcept;
// Both at little more than the cost of one; the same bits as sin() and cos().
[[nodiscard]] SinCos sin_cos(double x) noexcept;
// result[i] = sin_cos(x[i]), the same bits in about half the time. Both have the same size.
void sin_cos_each(std::span<const double> x, std::span<SinCos> result) noexcept;

// Angle of the point (x, y) in [-pi, pi], with the signs of zeros and infinities as in IEEE 754 (C17 F.10.1.4). NaN
// when x or y is one.
[[nodiscard]] double atan2(double y, double x) noexcept;
// angle[i] = atan2(y[i], x[i]), the same bits in about half the time. The three have the same size.
void atan2_each(std::span<const double> y, std::span<const double> x, std::span<double> angle) noexcept;

// sqrt(x^2 + y^2) without undue overflow or underflow. Infinite when x or y is, even beside a NaN (C17 F.10.4.3).
[[nodiscard]] double hypot(double x, double y) noexcept;

[[nodiscard]] constexpr double square(double x) noexcept {
  return x * x;
}

// The real cube root of any x; x itself for zeros, infinities and NaN.
[[nodiscard]] double cbrt(double x) noexcept;

}  // namespace armature::math
