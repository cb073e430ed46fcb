#include "controller/policy/policy_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace armature {
namespace {

PolicyScale two_inputs() {
  PolicyScale scale{.input_count = 2, .output_count = 2};
  scale.inputs[0] = {-127, 127};
  scale.inputs[1] = {10, 20};
  scale.full_output[0] = 12.7;
  scale.full_output[1] = 1;
  return scale;
}

TEST(PolicyScale, QuantisesARangeToMinus127To127) {
  const PolicyScale scale = two_inputs();
  const auto byte = [&scale](double first, double second) {
    const auto bytes = scale.quantised(std::vector<double>{first, second});
    return bytes ? std::pair<int, int>{(*bytes)[0], (*bytes)[1]} : std::pair<int, int>{999, 999};
  };
  EXPECT_EQ(byte(-127, 10), (std::pair{-127, -127}));
  EXPECT_EQ(byte(127, 20), (std::pair{127, 127}));
  EXPECT_EQ(byte(0, 15), (std::pair{0, 0}));
  EXPECT_EQ(byte(0.5, 15), (std::pair{1, 0})) << "halves away from 0";
  EXPECT_EQ(byte(-0.5, 15), (std::pair{-1, 0}));
  EXPECT_EQ(byte(0.4999, 15.019), (std::pair{0, 0}));
  EXPECT_EQ(byte(3.2, 15.020), (std::pair{3, 1}));
}

TEST(PolicyScale, HasNothingForAValueOutsideItsRange) {
  const PolicyScale scale = two_inputs();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(scale.quantised(std::vector<double>{127, 20}));
  for (const double outside : {9.999, 20.001, kInfinity, -kInfinity, std::nan("")}) {
    EXPECT_FALSE(scale.quantised(std::vector<double>{0, outside})) << outside;
  }
  EXPECT_FALSE(scale.quantised(std::vector<double>{0})) << "a value is missing";
}

TEST(PolicyScale, AFullOutputIsTheFullCorrection) {
  const auto correction = two_inputs().correction({127, -127, 50});
  EXPECT_DOUBLE_EQ(correction[0], 12.7);
  EXPECT_DOUBLE_EQ(correction[1], -1);
  EXPECT_EQ(correction[2], 0) << "no such output";
}

}  // namespace
}  // namespace armature
