#include "controller/language/job/execute/circle_points.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/controller/support/random.hpp"

namespace armature::job {
namespace {

TEST(CirclePoints, AreTheMiddlesOfRandomArcs) {
  test::Random random{77};
  for (int draw = 0; draw < 2'000; ++draw) {
    const Eigen::Vector3d center{random.real(-500, 500), random.real(-500, 500), random.real(-500, 500)};
    const Eigen::Vector3d x = Eigen::Vector3d{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)}.normalized();
    const Eigen::Vector3d y = x.cross(Eigen::Vector3d{random.real(-1, 1), 1, random.real(-1, 1)}).normalized();
    const double radius = random.real(1, 300), begin = random.real(0, 6), turn = random.integer(0, 1) == 0 ? 1 : -1;
    const double first = random.real(0.05, 3.0), second = random.real(0.05, 2 * std::numbers::pi - first - 0.05);
    const auto at = [&](double angle) {
      return Eigen::Vector3d{center +
                             radius * (std::cos(begin + turn * angle) * x + std::sin(begin + turn * angle) * y)};
    };
    const auto middles = middles_of_arcs(at(0), at(first), at(first + second));
    ASSERT_TRUE(middles) << "seed 77, draw " << draw;
    EXPECT_LT((middles->first_mm - at(first / 2)).norm(), 1e-6 * radius) << "seed 77, draw " << draw;
    EXPECT_LT((middles->second_mm - at(first + second / 2)).norm(), 1e-6 * radius) << "seed 77, draw " << draw;
  }
}

TEST(CirclePoints, NeedThreePointsThatAreNotOnOneLine) {
  EXPECT_FALSE(middles_of_arcs({0, 0, 0}, {1, 1, 1}, {2, 2, 2}));
  EXPECT_FALSE(middles_of_arcs({0, 0, 0}, {0, 0, 0}, {1, 0, 0}));
  EXPECT_FALSE(middles_of_arcs({0, 0, 0}, {1, 0, 0}, {1, 0, 0}));
  EXPECT_FALSE(middles_of_arcs({0, 0, 0}, {1, 0, 0}, {0, 0, 0}));
  EXPECT_TRUE(middles_of_arcs({0, 0, 0}, {1, 0.001, 0}, {2, 0, 0}));
}

}  // namespace
}  // namespace armature::job
