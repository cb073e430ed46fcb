#include "cosim/page/column_code.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace armature::cosim {
namespace {

using testing::ElementsAreArray;

// The opposite of column_code(), written from its description.
std::vector<std::int64_t> decoded(const ColumnCode& code) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : code.text) {
    if (c == '=') break;
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    bits = bits << 6U | static_cast<std::uint32_t>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xFFU);
  }
  std::vector<std::int64_t> values;
  std::uint64_t value = 0;
  unsigned shift = 0;
  for (const char c : bytes) {
    const auto byte = static_cast<std::uint64_t>(static_cast<unsigned char>(c));
    value |= (byte & 0x7FU) << shift;
    shift += 7;
    if (byte >= 0x80) continue;
    const auto half = static_cast<std::int64_t>(value >> 1U);
    values.push_back((value & 1U) == 0 ? half : -half - 1);
    value = 0;
    shift = 0;
  }
  for (int order = 0; order < code.order; ++order) {
    for (std::size_t i = 1; i < values.size(); ++i) values[i] += values[i - 1];
  }
  return values;
}

TEST(ColumnCode, GivesTheValuesBackExactly) {
  const std::vector<std::vector<std::int64_t>> columns{
      {}, {0}, {-1}, {63, 64, -64, -65, 8191, 8192}, {1, 2, 4, 8, 16, 32, 64}, {360'000'000'000, -360'000'000'000, 5}};
  for (const auto& column : columns) EXPECT_THAT(decoded(column_code(column)), ElementsAreArray(column));
}

TEST(ColumnCode, AMoveWithConstantAccelerationTakesAboutAByteAValue) {
  std::vector<std::int64_t> positions;
  for (std::int64_t i = 0; i < 3000; ++i) positions.push_back(300'000 * i * i);
  const ColumnCode code = column_code(positions);
  EXPECT_GE(code.order, 2);
  EXPECT_LT(code.text.size(), positions.size() * 3 / 2);
  EXPECT_THAT(decoded(code), ElementsAreArray(positions));
}

}  // namespace
}  // namespace armature::cosim
