#include "cosim/plot/axis_scale.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace armature::cosim {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

TEST(AxisScale, MarksAreRoundNumbersWithinTheRange) {
  const AxisScale scale = exact_scale(0.003, 1.0, 10);
  EXPECT_EQ(scale.step, 0.1);
  EXPECT_THAT(scale.marks(), Pointwise(DoubleNear(1e-12), {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}));
  EXPECT_EQ(scale.low, 0.003);
}

TEST(AxisScale, ExtendsTheRangeToWholeSteps) {
  const AxisScale scale = round_scale(-63, 84, 8);
  EXPECT_THAT(scale.marks(), ElementsAre(-80, -60, -40, -20, 0, 20, 40, 60, 80, 100));
}

TEST(AxisScale, ARangeOfWholeStepsIsNotExtended) {
  const AxisScale scale = round_scale(-0.3, 0.6, 9);
  EXPECT_NEAR(scale.low, -0.3, 1e-12);
  EXPECT_NEAR(scale.high, 0.6, 1e-12);
}

TEST(AxisScale, TextHasTheDigitsOfTheStepAndATypographicMinus) {
  EXPECT_EQ(exact_scale(-1, 1, 8).text(-0.5), "\u22120.5");
  EXPECT_EQ(exact_scale(-1, 1, 8).text(-1e-17), "0.0");
  EXPECT_EQ(exact_scale(0, 300, 8).text(150), "150");
  EXPECT_EQ(exact_scale(0, 0.02, 4).text(0.005), "0.005");
}

TEST(AxisScale, ARangeOfNothingStillHasAScale) {
  const AxisScale scale = exact_scale(5, 5, 8);
  EXPECT_GT(scale.high, scale.low);
}

}  // namespace
}  // namespace armature::cosim
