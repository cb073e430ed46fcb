#include "cosim/scenario/toml/value_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace armature::cosim {
namespace {

template <class T>
bool accepts(const ConfigValue::Data& data, const Rule& rule) {
  ProblemList problems{"f"};
  T out{};
  const bool accepted = convert(ConfigValue{data, {}}, "key", rule, problems, out);
  EXPECT_EQ(problems.size(), accepted ? 0u : 1u);
  return accepted;
}

TEST(ValueRule, ARangeHoldsItsEndsUnlessItIsAboveAMinimum) {
  EXPECT_TRUE(accepts<double>(1.0, between(1, 2)));
  EXPECT_TRUE(accepts<double>(2.0, between(1, 2)));
  EXPECT_FALSE(accepts<double>(std::nextafter(1.0, 0.0), between(1, 2)));
  EXPECT_FALSE(accepts<double>(std::nextafter(2.0, 3.0), between(1, 2)));
  EXPECT_FALSE(accepts<double>(1.0, above(1, 2)));
  EXPECT_TRUE(accepts<double>(std::nextafter(1.0, 2.0), above(1, 2)));
  EXPECT_TRUE(accepts<double>(2.0, above(1, 2)));
  EXPECT_TRUE(accepts<std::int64_t>(std::int64_t{6}, between(1, 6)));
  EXPECT_FALSE(accepts<std::int64_t>(std::int64_t{7}, between(1, 6)));
  EXPECT_TRUE(accepts<std::int64_t>(std::numeric_limits<std::int64_t>::max(), at_least(0)));
}

TEST(ValueRule, OnlyFiniteNumbersAreNumbers) {
  EXPECT_FALSE(accepts<double>(std::numeric_limits<double>::infinity(), anything()));
  EXPECT_FALSE(accepts<double>(-std::numeric_limits<double>::infinity(), anything()));
  EXPECT_FALSE(accepts<double>(std::numeric_limits<double>::quiet_NaN(), anything()));
}

TEST(ValueRule, AnIntegerIsANumberButNotTheOtherWayRound) {
  EXPECT_TRUE(accepts<double>(std::int64_t{3}, anything()));
  EXPECT_FALSE(accepts<std::int64_t>(3.0, anything()));
  EXPECT_FALSE(accepts<double>(true, anything()));
  EXPECT_FALSE(accepts<bool>(std::int64_t{1}, anything()));
  EXPECT_FALSE(accepts<std::string>(ConfigValue::Date{}, anything()));
}

}  // namespace
}  // namespace armature::cosim
