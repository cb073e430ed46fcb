// math::sin_cos_each against math::sin_cos, which math_test.cpp compares with MPFR.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>

#include "controller/base/math.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

constexpr std::array<double, 10> kSpecial{0.0,
                                          -0.0,
                                          std::numeric_limits<double>::denorm_min(),
                                          0x1p-28,
                                          0x1p-14,
                                          1e6,
                                          1.1e6,
                                          -std::numeric_limits<double>::infinity(),
                                          std::numeric_limits<double>::infinity(),
                                          std::numeric_limits<double>::quiet_NaN()};

// Neighbours that need the other way to the result, and spans of any length.
TEST(SinCosEach, HasTheBitsOfThoseComputedAlone) {
  test::Random random{111};
  std::array<double, 7> x;
  std::array<math::SinCos, 7> both;
  for (int round = 0; round < 20'000; ++round) {
    const auto count = static_cast<std::size_t>(random.integer(0, 7));
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t kind = random.integer(0, 7);
      x[i] = random.real(-7.0, 7.0);
      if (kind == 0) x[i] = kSpecial[static_cast<std::size_t>(random.integer(0, 9))];
      if (kind == 1) {  // near a multiple of pi/2
        x[i] = 0.5 * std::numbers::pi * static_cast<double>(random.integer(-600'000, 600'000));
        x[i] += std::ldexp(random.real(-1.0, 1.0), static_cast<int>(random.integer(-40, 0)));
      }
      if (kind == 2) x[i] = random.real(-1e6, 1e6);
    }
    math::sin_cos_each(std::span{x}.first(count), std::span{both}.first(count));
    for (std::size_t i = 0; i < count; ++i) {
      const math::SinCos one = math::sin_cos(x[i]);
      ASSERT_EQ(std::bit_cast<std::uint64_t>(both[i].sin), std::bit_cast<std::uint64_t>(one.sin))
          << std::hexfloat << x[i] << " seed 111";
      ASSERT_EQ(std::bit_cast<std::uint64_t>(both[i].cos), std::bit_cast<std::uint64_t>(one.cos))
          << std::hexfloat << x[i] << " seed 111";
    }
  }
}

}  // namespace
}  // namespace armature
