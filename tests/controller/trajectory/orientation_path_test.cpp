#include "controller/trajectory/path/orientation_path.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/controller/support/random.hpp"
#include "tests/controller/support/reference_data.hpp"

namespace armature {
namespace {

using nlohmann::json;

Eigen::Matrix3d matrix(const json& rows) {
  Eigen::Matrix3d m;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      m(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = rows[r][c].get<double>();
    }
  }
  return m;
}

Eigen::Vector3d random_unit_vector(test::Random& random) {
  Eigen::Vector3d v;
  do {
    v = {random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
  } while (v.norm() < 0.1);
  return v.normalized();
}

Eigen::Matrix3d random_rotation(test::Random& random) {
  return Eigen::AngleAxisd{random.real(-3.1, 3.1), random_unit_vector(random)}.toRotationMatrix();
}

TEST(OrientationPath, AgreesWithTheReferenceAlsoNear0AndNear180Degrees) {
  const json reference = test::read_reference("axis_angle.json");
  int compared = 0;
  for (const json& c : reference["cases"]) {
    SCOPED_TRACE(c["kind"].get<std::string>() + " " + c["theta"].dump());
    const OrientationPath path = turn(matrix(c["Ri"]), matrix(c["Rf"]));
    EXPECT_NEAR(path.angle_rad, c["theta"].get<double>(), c["tol_theta"].get<double>());
    const Eigen::Vector3d u{c["u"][0].get<double>(), c["u"][1].get<double>(), c["u"][2].get<double>()};
    EXPECT_LT((path.axis - u).norm(), c["tol_u"].get<double>() + (c["kind"] == "identity" ? 1.0 : 0.0));
    for (const json& sample : c["samples"]) {
      const Eigen::Matrix3d error = rotation(path, sample["f"].get<double>()) - matrix(sample["R"]);
      ASSERT_LT(error.cwiseAbs().maxCoeff(), c["tol_R"].get<double>()) << sample["f"];
      ++compared;
    }
  }
  EXPECT_GT(compared, 200);
}

TEST(OrientationPath, TurnsSteadilyAboutOneAxisAndStaysARotation) {
  test::Random random{20};
  for (int draw = 0; draw < 1'000; ++draw) {
    const Eigen::Vector3d axis = random_unit_vector(random);
    const double angle = random.real(0.0, std::numbers::pi);
    const Eigen::Matrix3d start = random_rotation(random);
    const OrientationPath path = turn(start, start * Eigen::AngleAxisd{angle, axis}.toRotationMatrix());
    for (const double s : {0.1, 0.4, 0.9}) {
      const Eigen::Matrix3d expected = start * Eigen::AngleAxisd{s * angle, axis}.toRotationMatrix();
      ASSERT_LT((rotation(path, s) - expected).cwiseAbs().maxCoeff(), 4e-15) << angle;
      const Eigen::Matrix3d product = turned(path, s).transpose() * turned(path, s);
      ASSERT_LT((product - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 4e-15);
    }
  }
}

TEST(OrientationPath, EndsExactlyWhereItWasAskedTo) {
  test::Random random{21};
  for (int draw = 0; draw < 200; ++draw) {
    const Eigen::Matrix3d start = random_rotation(random), end = random_rotation(random);
    const OrientationPath path = turn(start, end);
    ASSERT_EQ(rotation(path, 0.0), start);  // bit for bit
    ASSERT_EQ(rotation(path, -1.0), start);
    ASSERT_EQ(rotation(path, 1.0), end);
    ASSERT_EQ(rotation(path, 2.0), end);
    ASSERT_EQ(turned(path, 0.0), Eigen::Matrix3d::Identity());
    ASSERT_LT((start * turned(path, 1.0) - end).cwiseAbs().maxCoeff(), 4e-15);
    ASSERT_EQ(turned(path, 1.5), turned(path, 1.0));
    ASSERT_LT((rotation(path, 1.0 - 1e-13) - end).cwiseAbs().maxCoeff(), 1e-12);  // no jump
  }
}

TEST(OrientationPath, RoundingDoesNotDecideTheWayOfAHalfTurn) {
  test::Random random{22};
  for (int draw = 0; draw < 500; ++draw) {
    Eigen::Vector3d axis = random_unit_vector(random);
    Eigen::Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    if (axis[largest] < 0.0) axis = -axis;
    const Eigen::Matrix3d start = random_rotation(random);
    for (const double angle : {std::numbers::pi, -std::numbers::pi, std::numbers::pi - 2e-15}) {
      const OrientationPath path = turn(start, start * Eigen::AngleAxisd{angle, axis}.toRotationMatrix());
      ASSERT_EQ(path.angle_rad, std::numbers::pi);
      ASSERT_LT((path.axis - axis).norm(), 1e-13) << draw;
    }
  }
}

TEST(OrientationPath, ATurnByNothingStays) {
  test::Random random{23};
  const Eigen::Matrix3d here = random_rotation(random);
  const OrientationPath path = turn(Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity());
  EXPECT_EQ(path.angle_rad, 0.0);
  EXPECT_EQ(path.axis, Eigen::Vector3d::Zero());
  EXPECT_LT(turn(here, here).angle_rad, 1e-15);
  EXPECT_LT((rotation(turn(here, here), 0.5) - here).cwiseAbs().maxCoeff(), 4e-16);
}

}  // namespace
}  // namespace armature
