#include "cosim/trace/decimal_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

template <int kDigits>
std::string fixed(double value) {
  std::array<char, kMaxFixedText + 1> text{};
  return {text.data(), append_fixed<kDigits>(text.data(), value)};
}

template <int kDigits>
std::string of_the_library(double value) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, kDigits).ptr;
  std::string out{text.data(), end};
  if (out.starts_with('-') && out.find_first_not_of("-0.") == std::string::npos) out.erase(0, 1);
  return out;
}

void expect_equal(double value) {
  ASSERT_EQ(fixed<9>(value), of_the_library<9>(value)) << value;
  ASSERT_EQ(fixed<6>(value), of_the_library<6>(value)) << value;
}

TEST(DecimalText, IsThatOfTheLibraryForAnyDouble) {
  armature::test::SplitMix random{9};
  for (int i = 0; i < 50'000; ++i) {
    const double any = std::bit_cast<double>(random.next());
    if (std::fabs(any) < kLargestFixed) expect_equal(any);
    const auto integer = static_cast<double>(static_cast<std::int64_t>(random.next()) >> random.below(64));
    const double shifted = std::ldexp(integer, -static_cast<int>(random.below(90)));
    if (std::fabs(shifted) < kLargestFixed) expect_equal(shifted);
    expect_equal(static_cast<double>(random.below(2'000'000'000)) * 1e-9 + 0.5e-9);
  }
}

TEST(DecimalText, RoundsAHalfToAnEvenDigit) {
  EXPECT_EQ(fixed<6>(0.0000005), of_the_library<6>(0.0000005));
  for (int k = -64; k <= 64; ++k) expect_equal(k / 128.0 / 1024);  // halves of the ninth digit and of the sixth one
  EXPECT_EQ(fixed<2>(0.125), "0.12");
  EXPECT_EQ(fixed<2>(0.375), "0.38");
  EXPECT_EQ(fixed<2>(-0.375), "-0.38");
}

TEST(DecimalText, HasNoMinusBeforeAZero) {
  EXPECT_EQ(fixed<6>(-0.0), "0.000000");
  EXPECT_EQ(fixed<6>(-4e-7), "0.000000");
  EXPECT_EQ(fixed<6>(-6e-7), "-0.000001");
  EXPECT_EQ(fixed<9>(-5e-324), "0.000000000");
}

TEST(DecimalText, HasRoomForTheLargestValues) {
  EXPECT_EQ(fixed<9>(-999'999'999'999'999.875), "-999999999999999.875000000");
  EXPECT_EQ(fixed<9>(9223372036.854775), of_the_library<9>(9223372036.854775));
  std::array<char, kMaxIntegerText + 10> text{};
  EXPECT_EQ(std::string(text.data(), append_units<8>(text.data(), INT64_MAX)), "92233720368.54775807");
  EXPECT_EQ(std::string(text.data(), append_units<8>(text.data(), 7)), "0.00000007");
}

}  // namespace
}  // namespace armature::cosim
