#include "controller/base/math.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>

#include "tests/controller/support/mpfr_oracle.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();
constexpr double kPi = std::numbers::pi;

std::uint64_t bits(double v) {
  return std::bit_cast<std::uint64_t>(v);
}

// One draw after the other: the order in which arguments are evaluated is the compiler's choice.
double scaled(test::Random& random, double low, double high, int least_exponent, int most_exponent) {
  const double mantissa = random.real(low, high);
  return std::ldexp(mantissa, static_cast<int>(random.integer(least_exponent, most_exponent)));
}

// The largest errors seen by far denser sweeps than these, and a little more. The contract is 1.
constexpr double kSineUlps = 0.81;
constexpr double kAngleUlps = 0.57;
constexpr double kLengthUlps = 0.501;
constexpr double kTinyLengthUlps = 0.76;  // below the normal numbers it is rounded twice

class Mathematics : public testing::Test {
 protected:
  void check_sine_and_cosine(double x) {
    const math::SinCos both = math::sin_cos(x);
    exact_.sin(x);
    ASSERT_LE(exact_.ulps(both.sin), kSineUlps) << std::hexfloat << "sin " << x;
    exact_.cos(x);
    ASSERT_LE(exact_.ulps(both.cos), kSineUlps) << std::hexfloat << "cos " << x;
    ASSERT_EQ(bits(math::sin(x)), bits(both.sin)) << std::hexfloat << x;
    ASSERT_EQ(bits(math::cos(x)), bits(both.cos)) << std::hexfloat << x;
    ASSERT_EQ(bits(math::sin(-x)), bits(-both.sin)) << std::hexfloat << x;
    ASSERT_EQ(bits(math::cos(-x)), bits(both.cos)) << std::hexfloat << x;
    ASSERT_NEAR(both.sin * both.sin + both.cos * both.cos, 1.0, 4e-16) << std::hexfloat << x;
  }

  void check_angle(double y, double x) {
    const double angle = math::atan2(y, x);
    exact_.atan2(y, x);
    ASSERT_LE(exact_.ulps(angle), kAngleUlps) << std::hexfloat << "atan2(" << y << ", " << x << ")";
    ASSERT_EQ(bits(math::atan2(-y, x)), bits(-angle)) << std::hexfloat << "atan2(" << y << ", " << x << ")";
  }

  void check_length(double x, double y) {
    const double length = math::hypot(x, y);
    exact_.hypot(x, y);
    ASSERT_LE(exact_.ulps(length), length < 0x1p-1022 ? kTinyLengthUlps : kLengthUlps)
        << std::hexfloat << "hypot(" << x << ", " << y << ")";
    ASSERT_EQ(bits(math::hypot(-y, x)), bits(length)) << std::hexfloat << x << " " << y;
  }

  // Angle and length of a point.
  void check_point(double x, double y) {
    ASSERT_NO_FATAL_FAILURE(check_angle(y, x));
    ASSERT_NO_FATAL_FAILURE(check_length(x, y));
  }

  test::MpfrOracle exact_;
};

TEST_F(Mathematics, SineAndCosineAreWithinAnUlpInTheFirstTurns) {
  test::Random random{101};
  for (int i = -12'000; i <= 12'000; ++i) ASSERT_NO_FATAL_FAILURE(check_sine_and_cosine(i * 0x1p-10)) << "dense";
  for (int i = 0; i < 30'000; ++i) ASSERT_NO_FATAL_FAILURE(check_sine_and_cosine(random.real(-7.0, 7.0))) << "seed 101";
}

TEST_F(Mathematics, SineAndCosineAreWithinAnUlpUpToAMillionRadians) {
  test::Random random{102};
  for (int i = 0; i < 20'000; ++i) ASSERT_NO_FATAL_FAILURE(check_sine_and_cosine(random.real(-1e6, 1e6))) << "seed 102";
  for (const double x : {1e6, std::nextafter(1e6, 0.0), 999'999.0}) ASSERT_NO_FATAL_FAILURE(check_sine_and_cosine(x));
}

TEST_F(Mathematics, SineAndCosineAreWithinAnUlpNextToEveryMultipleOfHalfPi) {
  for (std::int64_t n = 1; n < 636'619; n += n < 1'000 ? 1 : 53) {
    const double x = exact_.half_pis(n);
    ASSERT_NO_FATAL_FAILURE(check_sine_and_cosine(x)) << n;
    ASSERT_NO_FATAL_FAILURE(check_sine_and_cosine(std::nextafter(x, 0.0))) << n;
  }
  // The nearest of all up to a million, 2^-60 .. 2^-49 away: absolute, and then in relation to the number of quarters.
  for (const double x : {0x1.6c6cbc45dc8dep+5, 0x1.6c6cbc45dc8dep+11, 0x1.39c6fd67805a7p+18, 0x1.a9adcc7f96cf0p+19,
                         0x1.93c05c9ed3cbcp+18, 0x1.edb9bbd6273d1p+18, 0x1.23d98d86bd573p+19, 0x1.bf9b3c6059d24p+17,
                         0x1.4fb46d48435dbp+19, 0x1.7dd2ecbe10c88p+19, 0x1.d7cc4bf56439dp+19, 0x1.d588ac411cd58p+19,
                         0x1.65a1dd290660fp+16}) {
    ASSERT_NO_FATAL_FAILURE(check_sine_and_cosine(x));
  }
}

TEST_F(Mathematics, SineAndCosineAreWithinAnUlpAtEveryDistanceFromAMultipleOfHalfPi) {
  test::Random random{103};
  for (int i = 0; i < 20'000; ++i) {
    const double x = exact_.half_pis(random.integer(-600'000, 600'000));
    const double away = scaled(random, -1.0, 1.0, -40, 0);
    ASSERT_NO_FATAL_FAILURE(check_sine_and_cosine(x + away)) << "seed 103";
  }
}

TEST_F(Mathematics, SineAndCosineAreWithinAnUlpAtTheBordersOfQuadrants) {
  for (std::int64_t n = -401; n <= 401; n += 2) {
    double x = 0.5 * exact_.half_pis(n);  // odd multiples of pi/4
    for (int i = 0; i < 20; ++i) x = std::nextafter(x, -kInfinity);
    for (int i = 0; i < 40; ++i, x = std::nextafter(x, kInfinity)) ASSERT_NO_FATAL_FAILURE(check_sine_and_cosine(x));
  }
}

TEST_F(Mathematics, SineAndCosineOfTinyNumbers) {
  test::Random random{104};
  for (int exponent = -1074; exponent <= 0; ++exponent) {
    for (int i = 0; i < 8; ++i) {
      ASSERT_NO_FATAL_FAILURE(check_sine_and_cosine(std::ldexp(random.real(0.5, 1.0), exponent))) << "seed 104";
    }
  }
  for (const double x : {kLeast, 0x1p-1022, 0x1p-27, std::nextafter(0x1p-27, 0.0), 0x1p-13}) {
    ASSERT_NO_FATAL_FAILURE(check_sine_and_cosine(x));
  }
  EXPECT_EQ(bits(math::sin(0.0)), bits(0.0));
  EXPECT_EQ(bits(math::sin(-0.0)), bits(-0.0));
  EXPECT_EQ(math::cos(-0.0), 1.0);
}

TEST_F(Mathematics, SineAndCosineBeyondTheirRangeAreNan) {
  for (const double x : {std::nextafter(1e6, 2e6), -1e7, kLargest, kInfinity, -kInfinity, kNan}) {
    EXPECT_TRUE(std::isnan(math::sin(x)) && std::isnan(math::cos(x))) << x;
    EXPECT_TRUE(std::isnan(math::sin_cos(x).sin) && std::isnan(math::sin_cos(x).cos)) << x;
  }
}

TEST_F(Mathematics, AnglesAndLengthsOfPointsAllAround) {
  test::Random random{105};
  for (int i = 0; i < 40'000; ++i) {
    const double x = random.real(-1.0, 1.0), y = random.real(-1.0, 1.0);
    ASSERT_NO_FATAL_FAILURE(check_point(x, y)) << "seed 105";
  }
  for (int i = 0; i < 20'000; ++i) {  // dense in the angle
    const double angle = i * (2.0 * kPi / 20'000);
    ASSERT_NO_FATAL_FAILURE(check_point(900.0 * std::cos(angle), 900.0 * std::sin(angle)));
  }
}

TEST_F(Mathematics, AnglesAndLengthsOfPointsAtEveryGapOfExponents) {
  test::Random random{106};
  for (int gap = -2'100; gap <= 2'100; ++gap) {
    const int least = std::max(-1074, -1074 - gap), most = std::min(1024, 1024 - gap);
    if (least > most) continue;
    for (int i = 0; i < 8; ++i) {
      const int exponent = static_cast<int>(random.integer(least, most));
      const double x = std::ldexp(random.real(0.5, 1.0), exponent + gap),
                   y = std::ldexp(random.real(0.5, 1.0), exponent);
      ASSERT_NO_FATAL_FAILURE(check_point(i % 2 == 0 ? x : -x, i % 4 < 2 ? y : -y)) << "seed 106";
    }
  }
}

TEST_F(Mathematics, AnglesAndLengthsOfPointsOfAnyBits) {
  test::Random random{107};
  for (int i = 0; i < 20'000; ++i) {
    const double x = std::bit_cast<double>(random.bits()), y = std::bit_cast<double>(random.bits());
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    ASSERT_NO_FATAL_FAILURE(check_point(x, y)) << "seed 107";
    const double near = std::ldexp(x, static_cast<int>(random.integer(-80, 80)));  // and with a smaller gap
    if (!std::isfinite(near)) continue;
    ASSERT_NO_FATAL_FAILURE(check_point(x, near)) << "seed 107";
  }
}

TEST_F(Mathematics, AnglesBetweenTwoBreakpointsAndAtTheOctants) {
  test::Random random{108};
  for (int k = 0; k <= 128; ++k) {
    for (int i = 0; i < 100; ++i) {
      const double x = random.real(0.5, 1.0) * (i % 2 == 0 ? 1.0 : -1.0);
      const double y = std::fabs(x) * (k / 128.0 + random.real(-1.0, 1.0) * (i % 5 == 0 ? 1e-15 : 1e-6));
      ASSERT_NO_FATAL_FAILURE(check_angle(y, x)) << "seed 108";
      ASSERT_NO_FATAL_FAILURE(check_angle(x, y)) << "seed 108";
    }
  }
  EXPECT_EQ(math::atan2(3.0, 3.0), 0.25 * kPi);
  EXPECT_EQ(math::atan2(3.0, -3.0), 0.75 * kPi);
  EXPECT_EQ(math::atan2(-3.0, 3.0), -0.25 * kPi);
  EXPECT_EQ(math::atan2(-3.0, -3.0), -0.75 * kPi);
}

// C17 F.10.1.4.
TEST_F(Mathematics, AnglesOfZerosInfinitiesAndNansAreThoseOfTheStandard) {
  struct Case {
    double y, x, angle;
  };
  for (const Case& c : {Case{0.0, 0.0, 0.0},
                        {0.0, 1.0, 0.0},
                        {0.0, kInfinity, 0.0},
                        {0.0, -0.0, kPi},
                        {0.0, -1.0, kPi},
                        {0.0, -kInfinity, kPi},
                        {1.0, 0.0, 0.5 * kPi},
                        {1.0, -0.0, 0.5 * kPi},
                        {kLeast, 0.0, 0.5 * kPi},
                        {1.0, kInfinity, 0.0},
                        {1.0, -kInfinity, kPi},
                        {kInfinity, 0.0, 0.5 * kPi},
                        {kInfinity, 1.0, 0.5 * kPi},
                        {kInfinity, -kLargest, 0.5 * kPi},
                        {kInfinity, kInfinity, 0.25 * kPi},
                        {kInfinity, -kInfinity, 0.75 * kPi}}) {
    EXPECT_EQ(bits(math::atan2(c.y, c.x)), bits(c.angle)) << c.y << " " << c.x;
    EXPECT_EQ(bits(math::atan2(-c.y, c.x)), bits(-c.angle)) << -c.y << " " << c.x;
  }
  for (const double other : {0.0, 1.0, kInfinity, kNan}) {
    EXPECT_TRUE(std::isnan(math::atan2(kNan, other))) << other;
    EXPECT_TRUE(std::isnan(math::atan2(other, kNan))) << other;
  }
}

TEST_F(Mathematics, AnglesComputedTogetherHaveTheBitsOfThoseComputedAlone) {
  constexpr double kSpecial[] = {0.0, -0.0, kInfinity, -kInfinity, kNan, kLeast, kLargest, 1.0};
  test::Random random{64};
  std::array<double, 13> y{}, x{}, angle{};
  for (int round = 0; round < 20'000; ++round) {
    const auto count = static_cast<std::size_t>(random.integer(0, 13));
    for (std::size_t i = 0; i < count; ++i) {
      const bool special = random.integer(0, 15) == 0;
      y[i] = special ? kSpecial[random.integer(0, 7)] : scaled(random, -1, 1, -40, 40);
      x[i] = special ? kSpecial[random.integer(0, 7)] : scaled(random, -1, 1, -4, 4);
    }
    math::atan2_each(std::span{y}.first(count), std::span{x}.first(count), std::span{angle}.first(count));
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(bits(angle[i]), bits(math::atan2(y[i], x[i]))) << std::hexfloat << y[i] << ", " << x[i];
    }
  }
}

TEST_F(Mathematics, LengthsAreExactWhereTheyCanBe) {
  for (const double scale : {1.0, 0x1p-1070, 0x1p-700, 0x1p+300, 0x1p+1010}) {
    EXPECT_EQ(math::hypot(3.0 * scale, -4.0 * scale), 5.0 * scale);
    EXPECT_EQ(math::hypot(0.0, -7.0 * scale), 7.0 * scale);
  }
  EXPECT_EQ(math::hypot(20.0, 21.0), 29.0);
  EXPECT_EQ(bits(math::hypot(-0.0, 0.0)), bits(0.0));
  EXPECT_EQ(math::hypot(kLargest, 0.0), kLargest);
  EXPECT_EQ(math::hypot(kLargest, 1.0), kLargest);
  EXPECT_EQ(math::hypot(kLargest, kLargest), kInfinity);
  EXPECT_EQ(math::hypot(kLeast, 0.0), kLeast);
  EXPECT_EQ(math::hypot(-kInfinity, kNan), kInfinity);
  EXPECT_EQ(math::hypot(kNan, kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(math::hypot(kNan, 1.0)));
  EXPECT_TRUE(std::isnan(math::hypot(0.0, kNan)));
}

TEST_F(Mathematics, CubeRootsOfAllMagnitudes) {
  test::Random random{110};
  for (int i = 0; i < 40'000; ++i) {
    const double x = i % 2 == 0 ? random.real(0.0, 8.0) : scaled(random, 0.5, 1.0, -1073, 1024);
    exact_.cbrt(x);
    ASSERT_LE(exact_.ulps(math::cbrt(x)), kLengthUlps) << std::hexfloat << "seed 110, cbrt " << x;
    ASSERT_EQ(bits(math::cbrt(-x)), bits(-math::cbrt(x))) << std::hexfloat << x;
  }
  for (int n = 1; n <= 1'000; ++n) ASSERT_EQ(math::cbrt(1.0 * n * n * n), n);
  for (const double same : {0.0, -0.0, kInfinity, -kInfinity}) EXPECT_EQ(bits(math::cbrt(same)), bits(same));
  EXPECT_TRUE(std::isnan(math::cbrt(kNan)));
}

// One number for 240 000 results: it must be the same with every compiler, at every level of optimisation and on every
// machine. A changed coefficient changes it.
TEST_F(Mathematics, TheBitsAreTheSameEverywhere) {
  test::Random random{109};
  std::uint64_t hash = 0xCBF29CE484222325u;
  const auto take = [&hash](double v) { hash = (hash ^ bits(v)) * 0x100000001B3u; };
  for (int i = 0; i < 40'000; ++i) {
    const double x = random.real(-1.0, 1.0);
    const double y = scaled(random, -1.0, 1.0, -30, 3);
    const math::SinCos both = math::sin_cos(i % 8 == 0 ? x * 1e6 : x * 6.5);
    take(both.sin);
    take(both.cos);
    take(math::sin(y));
    take(math::atan2(y, x));
    take(math::hypot(x, y));
    take(math::cbrt(y));
  }
  EXPECT_EQ(hash, 0xc4328404d8f35743u) << std::hex << hash;
}

}  // namespace
}  // namespace armature
