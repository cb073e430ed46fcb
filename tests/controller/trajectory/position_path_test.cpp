#include "controller/trajectory/path/position_path.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "tests/controller/support/random.hpp"
#include "tests/controller/support/reference_data.hpp"

namespace armature {
namespace {

using nlohmann::json;

Eigen::Vector3d vector(const json& v, std::size_t first = 0) {
  return {v[first].get<double>(), v[first + 1].get<double>(), v[first + 2].get<double>()};
}

Eigen::Vector3d random_point(test::Random& random, double size) {
  return {random.real(-size, size), random.real(-size, size), random.real(-size, size)};
}

TEST(PositionPath, ArcsAndCirclesAgreeWithTheReference) {
  const json reference = test::read_reference("arcs.json");
  int compared = 0;
  for (const json& c : reference["arcs"]) {
    SCOPED_TRACE(c["kind"].get<std::string>() + " " + c["P"].dump());
    const Eigen::Vector3d p1 = vector(c["P"][0]), p2 = vector(c["P"][1]), p3 = vector(c["P"][2]);
    const auto path = arc(p1, p2, p3);
    const auto whole = circle(p1, p2, p3);
    ASSERT_EQ(path.has_value(), c["status"] == "ok");
    ASSERT_EQ(whole.has_value(), c["status"] == "ok");
    if (!path) continue;
    const double tolerance = c["tol_rel"].get<double>();
    const double size = std::max({1.0, p1.cwiseAbs().maxCoeff(), p2.cwiseAbs().maxCoeff(), p3.cwiseAbs().maxCoeff()});
    const double radius = c["radius"].get<double>();
    EXPECT_NEAR(path->radius_mm, radius, tolerance * radius);
    EXPECT_NEAR(path->angle_rad, c["phi3"].get<double>(), tolerance);
    EXPECT_NEAR(path->length_mm, c["length"].get<double>(), tolerance * size);
    EXPECT_LT((path->center_mm - vector(c["center"])).norm(), tolerance * std::max(size, radius));
    for (std::size_t row = 0; row < 3; ++row) {
      const auto i = static_cast<Eigen::Index>(row);
      EXPECT_NEAR(path->x[i], c["R"][row][0].get<double>(), tolerance);
      EXPECT_NEAR(path->y[i], c["R"][row][1].get<double>(), tolerance);
    }
    for (const json& sample : c["samples"]) {
      const Eigen::Vector3d error = point(*path, sample[0].get<double>()) - vector(sample, 1);
      ASSERT_LT(error.norm(), tolerance * size) << sample.dump();
      ++compared;
    }
    for (const json& sample : c["full_circle_samples"]) {
      const Eigen::Vector3d error = point(*whole, sample[0].get<double>()) - vector(sample, 1);
      ASSERT_LT(error.norm(), tolerance * std::max(size, radius)) << sample.dump();
    }
  }
  EXPECT_GT(compared, 400);
}

TEST(PositionPath, AnArcPassesThroughItsThreePointsAndStaysInTheirPlaneOnTheirCircle) {
  test::Random random{15};
  for (int draw = 0; draw < 2'000; ++draw) {
    const Eigen::Vector3d p1 = random_point(random, 500.0), p2 = random_point(random, 500.0),
                          p3 = random_point(random, 500.0);
    const Eigen::Vector3d normal = (p2 - p1).cross(p3 - p1);
    if (normal.norm() < 1e3) continue;  // flat: the tolerances below are absolute
    const auto path = arc(p1, p2, p3);
    ASSERT_TRUE(path);
    ASSERT_EQ(point(*path, 0.0), p1);  // bit for bit
    ASSERT_EQ(point(*path, 1.0), p3);
    // The share at which the arc is nearest to the second point: from its angle about the centre.
    const Eigen::Vector3d from_center = p2 - path->center_mm;
    double phi = std::atan2(path->y.dot(from_center), path->x.dot(from_center));
    if (phi < 0.0) phi += 2.0 * std::numbers::pi;
    ASSERT_LT(phi, path->angle_rad);
    ASSERT_LT((point(*path, phi / path->angle_rad) - p2).norm(), 1e-9 * path->radius_mm);
    for (const double s : {0.1, 0.37, 0.5, 0.81, 1.0 - 1e-12}) {
      const Eigen::Vector3d p = point(*path, s);
      ASSERT_NEAR((p - path->center_mm).norm(), path->radius_mm, 1e-9 * path->radius_mm);
      ASSERT_NEAR(normal.normalized().dot(p - p1), 0.0, 1e-9 * path->radius_mm);
      ASSERT_LT((p - (path->center_mm + path->radius_mm * (std::cos(s * path->angle_rad) * path->x +
                                                           std::sin(s * path->angle_rad) * path->y)))
                    .norm(),
                1e-9 * path->radius_mm);
    }
    ASSERT_LT((point(*path, 1.0 - 1e-13) - p3).norm(), 1e-9 * path->radius_mm);
  }
}

TEST(PositionPath, TheTangentIsTheDerivativeOverTheLength) {
  test::Random random{16};
  for (int draw = 0; draw < 1'000; ++draw) {
    const Eigen::Vector3d p1 = random_point(random, 500.0), p2 = random_point(random, 500.0),
                          p3 = random_point(random, 500.0);
    const auto bent = circle(p1, p2, p3);
    ASSERT_TRUE(bent);
    for (const PositionPath& path : {*bent, line(p1, p2)}) {
      const double s = random.real(0.01, 0.99), h = 1e-6;
      const Eigen::Vector3d derivative = (point(path, s + h) - point(path, s - h)) / (2.0 * h * path.length_mm);
      ASSERT_LT((derivative - tangent(path, s)).norm(), 1e-8);
      ASSERT_NEAR(tangent(path, s).norm(), 1.0, 1e-14);
      ASSERT_LT((tangent(path, 2.0) - tangent(path, 1.0)).norm(), 1e-15);
    }
  }
}

TEST(PositionPath, ALineIsExactAtBothEndsAndBeyond) {
  const Eigen::Vector3d a{0.1, -273.3, 1e-3}, b{410.7, 0.2, 77.7};
  const PositionPath path = line(a, b);
  EXPECT_EQ(point(path, 0.0), a);
  EXPECT_EQ(point(path, -1.0), a);
  EXPECT_EQ(point(path, 1.0), b);
  EXPECT_EQ(point(path, 1.1), b);
  EXPECT_LT((point(path, 0.25) - (0.75 * a + 0.25 * b)).norm(), 1e-12);
  EXPECT_DOUBLE_EQ(path.length_mm, (b - a).norm());
}

TEST(PositionPath, APointHasNoLengthAndNoDirection) {
  const Eigen::Vector3d here{1.0, 2.0, 3.0};
  const PositionPath path = line(here, here);
  EXPECT_EQ(path.length_mm, 0.0);
  EXPECT_EQ(tangent(path, 0.5), Eigen::Vector3d::Zero());
  EXPECT_EQ(point(path, 0.5), here);
}

TEST(PositionPath, TinyAndHugeArcsKeepTheirShape) {
  for (const double scale : {1e-60, 1e-9, 1.0, 1e9, 1e60}) {
    const auto path = arc(Eigen::Vector3d{scale, 0, 0}, Eigen::Vector3d{0, scale, 0}, Eigen::Vector3d{-scale, 0, 0});
    ASSERT_TRUE(path) << scale;
    EXPECT_NEAR(path->radius_mm / scale, 1.0, 1e-15) << scale;
    EXPECT_NEAR(path->angle_rad, std::numbers::pi, 1e-15) << scale;
    EXPECT_NEAR(point(*path, 0.5).y() / scale, 1.0, 1e-15) << scale;
  }
}

TEST(PositionPath, PointsThatDetermineNoCircleAreRefused) {
  const Eigen::Vector3d a{0, 0, 0}, b{100, 0, 0}, c{200, 0, 0}, nearly{100, 0.5e-8, 0}, enough{100, 2e-8 * 2, 0};
  EXPECT_FALSE(arc(a, b, c));
  EXPECT_FALSE(arc(a, a, b));
  EXPECT_FALSE(arc(a, b, b));
  EXPECT_FALSE(arc(a, b, a));
  EXPECT_FALSE(arc(a, a, a));
  EXPECT_FALSE(arc(a, nearly, c));
  EXPECT_TRUE(arc(a, enough, c));
  EXPECT_FALSE(circle(a, b, c));
  EXPECT_FALSE(arc(a, {std::numeric_limits<double>::quiet_NaN(), 1, 0}, c));
  EXPECT_FALSE(arc(a, {std::numeric_limits<double>::infinity(), 1, 0}, c));
  EXPECT_FALSE(arc(a, {1e200, 1e200, 0}, {1e200, -1e200, 0}));
}

}  // namespace
}  // namespace armature
