#include "cosim/plot/simplify.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace armature::cosim {
namespace {

TEST(Simplify, AStraightLineNeedsItsEndsOnly) {
  std::vector<PlotPoint> line;
  for (int i = 0; i <= 100; ++i) line.push_back({i * 1.0, i * 0.5});
  const auto simple = simplify(line, 0.01);
  ASSERT_EQ(simple.size(), 2U);
  EXPECT_EQ(simple.back().x, 100);
}

TEST(Simplify, NoPointIsFartherAwayThanTheTolerance) {
  constexpr double kTolerance = 0.05;
  std::vector<PlotPoint> wave;
  for (int i = 0; i <= 2000; ++i) wave.push_back({i * 0.25, 80 * std::sin(i * 0.01)});
  const auto simple = simplify(wave, kTolerance);
  EXPECT_LT(simple.size(), wave.size() / 5);
  std::size_t segment = 0;
  for (const PlotPoint point : wave) {
    while (simple[segment + 1].x < point.x) ++segment;
    const PlotPoint a = simple[segment];
    const PlotPoint b = simple[segment + 1];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const double distance = std::fabs((b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x)) / length;
    EXPECT_LE(distance, kTolerance * 1.0001);
  }
}

TEST(Simplify, AClosedLineKeepsItsFarSide) {
  const auto simple = simplify({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}}, 0.1);
  EXPECT_EQ(simple.size(), 5U);
}

}  // namespace
}  // namespace armature::cosim
