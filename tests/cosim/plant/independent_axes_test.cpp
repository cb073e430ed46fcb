// Six axes at once, against the position loop of each axis alone.
#include "cosim/plant/independent_axes.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "cosim/plant/counts_per_rev.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

using armature::test::SplitMix;

constexpr std::uint64_t kIndependentAxesSeed = 5;

TEST(IndependentAxes, MoveAsEachAxisAlone) {
  SplitMix random{kIndependentAxesSeed};
  const RobotSpec robot;
  IndependentAxes axes{robot};
  const PositionLoop loop{robot.axes[0].drive, static_cast<double>(counts_per_rev(robot.axes[0]))};
  const auto number = [&random](double size) {
    return (static_cast<double>(random.below(2'000'001)) * 1e-6 - 1) * size;
  };
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kIndependentAxesSeed << ", draw " << i);
    MotorDemands demands;
    demands.controlled = static_cast<std::uint8_t>(random.below(kAllAxes + 1));
    const auto stepped = static_cast<std::uint8_t>(random.below(kAllAxes + 1));
    Shafts shafts;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double size = random.below(3) == 0 ? 1e-6 : random.below(2) == 0 ? 10.0 : 30'000.0;
      if (random.below(6) != 0) shafts.set(axis, {.error = number(size), .speed = number(size * 0.01)});
    }
    Shafts wanted = shafts;
    for_each_bit(stepped, [&](std::size_t axis) {
      Shaft shaft = wanted[axis];
      if (has_bit(demands.controlled, axis)) {
        loop.step(shaft);
      } else {
        loop.brake(shaft);
      }
      wanted.set(axis, shaft);
    });
    EXPECT_EQ(axes.step(stepped, demands, shafts), stepped);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      ASSERT_EQ(shafts[axis].error, wanted[axis].error) << "axis " << axis;
      ASSERT_EQ(shafts[axis].speed, wanted[axis].speed) << "axis " << axis;
    }
  }
}

}  // namespace
}  // namespace armature::cosim
