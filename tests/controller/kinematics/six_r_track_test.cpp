#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "controller/kinematics/six_r.hpp"
#include "tests/controller/support/robots.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

using test::kPi;
constexpr std::uint64_t kTrackSeed = 1521;

// Each joint a sum of two sines about a centre.
class SmoothPath {
 public:
  explicit SmoothPath(test::Random& random) {
    for (Joint& joint : joints_) {
      joint.centre = random.real(-1.5, 1.5);
      for (std::size_t k = 0; k < 2; ++k) {
        joint.amplitude[k] = random.real(0.1, 1.0);
        joint.frequency[k] = random.real(1.0, 8.0);
        joint.phase[k] = random.real(0.0, 2.0 * kPi);
      }
    }
  }
  void centre(std::size_t joint, double value) { joints_[joint].centre = value; }
  void scale(std::size_t joint, double factor) {
    for (double& amplitude : joints_[joint].amplitude) amplitude *= factor;
  }
  void drift(std::size_t joint, double rate) { joints_[joint].drift = rate; }

  [[nodiscard]] Theta operator()(double s) const {
    Theta theta;
    for (std::size_t i = 0; i < 6; ++i) {
      const Joint& joint = joints_[i];
      theta[i] = joint.centre + joint.drift * s;
      for (std::size_t k = 0; k < 2; ++k) {
        theta[i] += joint.amplitude[k] * std::sin(joint.frequency[k] * s + joint.phase[k]);
      }
    }
    return theta;
  }

 private:
  struct Joint {
    double centre, drift = 0.0, amplitude[2], frequency[2], phase[2];
  };
  PerAxis<Joint> joints_;
};

// The reference: every branch of inverse(), every joint at its turn nearest to `previous`; least largest step, then
// least sum of squares (branches of one shoulder share the step of joint 1).
Theta nearest_of_all(const RawSolutions& solutions, const Theta& previous) {
  Theta best{};
  double least = std::numeric_limits<double>::infinity(), least_squares = least;
  for (std::size_t k = 0; k < solutions.count; ++k) {
    Theta theta;
    double largest = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < 6; ++i) {
      theta[i] = previous[i] + std::remainder(solutions.branches[k].theta[i] - previous[i], 2.0 * kPi);
      const double step = theta[i] - previous[i];
      largest = std::max(largest, std::fabs(step));
      squares += step * step;
    }
    if (largest < least || (largest == least && squares < least_squares)) {
      least = largest;
      least_squares = squares;
      best = theta;
    }
  }
  return best;
}

double largest_difference(const Theta& a, const Theta& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < 6; ++i) worst = std::max(worst, std::fabs(a[i] - b[i]));
  return worst;
}

TEST(SixRTrack, FollowsAPathThroughTheWristSingularityAndOverManyTurns) {
  test::Random random{kTrackSeed};
  int crossings = 0;
  for (const ArmGeometry& geometry : test::vendor_arms()) {
    const SixR arm{geometry};
    const double phi = std::atan2(geometry.d4_mm, geometry.a3_mm);
    for (int repeat = 0; repeat < 6; ++repeat) {
      SmoothPath path{random};
      path.centre(2, phi - kPi / 2);  // this side of the stretched elbow
      path.scale(2, 0.6);
      path.centre(4, random.real(-0.3, 0.3));  // theta_5 swings through 0
      path.drift(5, 8.0 * kPi);                // four turns of joint 6
      path.drift(0, 2.0 * kPi);
      Theta tracked = path(0.0), before = tracked;
      for (int sample = 1; sample <= 2000; ++sample) {
        const Theta truth = path(sample * 5e-4);
        const RawTracking tracking = arm.track(arm.forward(truth), tracked);
        ASSERT_TRUE(solved(tracking.status)) << "seed " << kTrackSeed << " " << repeat << " " << sample;
        tracked = tracking.theta;
        ASSERT_LT(largest_difference(tracked, truth), 1e-8) << "seed " << kTrackSeed << " " << repeat << " " << sample;
        crossings += std::signbit(before[4]) != std::signbit(truth[4]) ? 1 : 0;
        before = truth;
      }
      ASSERT_GT(tracked[5] - path(0.0)[5], 6.0 * kPi);
    }
  }
  EXPECT_GT(crossings, 20);
}

// Any smooth path: stretched elbows and arms that pass axis 1 included, where the nearest may be another branch than
// the one that made the pose.
TEST(SixRTrack, IsTheNearestOfAllBranchesOnSmoothPaths) {
  test::Random random{kTrackSeed};
  int near_elbow = 0, near_shoulder = 0, near_wrist = 0;
  for (const ArmGeometry& geometry : test::vendor_arms()) {
    const SixR arm{geometry};
    for (int repeat = 0; repeat < 12; ++repeat) {
      SmoothPath path{random};
      path.centre(2, std::atan2(geometry.d4_mm, geometry.a3_mm) + random.real(-0.5, 0.5));
      Theta previous = path(0.0);
      for (int sample = 1; sample <= 700; ++sample) {
        const Theta truth = path(sample * 1e-3);
        const Transform pose = arm.forward(truth);
        const RawTracking tracking = arm.track(pose, previous);
        ASSERT_TRUE(solved(tracking.status)) << "seed " << kTrackSeed << " " << repeat << " " << sample;
        const Theta expected = nearest_of_all(arm.inverse(pose, previous), previous);
        ASSERT_LT(largest_difference(tracking.theta, expected), 1e-12)
            << "seed " << kTrackSeed << " " << repeat << " " << sample;
        const Manipulability away = arm.manipulability(truth);
        near_elbow += away.elbow < 0.01 ? 1 : 0;
        near_shoulder += away.shoulder < 0.01 ? 1 : 0;
        near_wrist += away.wrist < 0.01 ? 1 : 0;
        previous = tracking.theta;
      }
    }
  }
  EXPECT_GT(near_elbow, 50);
  EXPECT_GT(near_shoulder, 50);
  EXPECT_GT(near_wrist, 50);
}

TEST(SixRTrack, PicksTheNearestOfAllBranchesAlsoAfterALargeStepOfTheWrist) {
  test::Random random{kTrackSeed};
  for (const ArmGeometry& geometry : test::vendor_arms()) {
    const SixR arm{geometry};
    const double phi = std::atan2(geometry.d4_mm, geometry.a3_mm);
    for (int i = 0; i < 1000; ++i) {
      Theta truth = test::random_angles(random, 3.0), previous = truth;
      truth[2] = phi + std::pow(10.0, random.real(-6, -1));  // elbows that differ by less than the wrist moves
      for (std::size_t k = 0; k < 6; ++k) previous[k] = truth[k] + random.real(-1, 1) * (k < 3 ? 0.2 : 1.5);
      const Transform pose = arm.forward(truth);
      const RawTracking tracking = arm.track(pose, previous);
      ASSERT_TRUE(solved(tracking.status)) << "seed " << kTrackSeed << " " << i;
      const Theta expected = nearest_of_all(arm.inverse(pose, previous), previous);
      ASSERT_LT(largest_difference(tracking.theta, expected), 1e-12) << "seed " << kTrackSeed << " " << i;
    }
  }
}

TEST(SixRTrack, CrossingTheWristSingularityKeepsTheta4AndTheta6) {
  const SixR arm{test::irb120_geometry()};
  Theta tracked{0.3, 1.2, 0.4, 1.0, 2e-3, -0.7};
  for (int sample = 1; sample <= 40; ++sample) {
    Theta truth = tracked;
    truth[4] = 2e-3 - sample * 1e-4;  // exactly 0 at sample 20
    const RawTracking tracking = arm.track(arm.forward(truth), tracked);
    EXPECT_EQ(tracking.status, sample == 20 ? IkStatus::kSingular : IkStatus::kOk) << sample;
    tracked = tracking.theta;
    EXPECT_NEAR(tracked[3], 1.0, 1e-10) << sample;
    EXPECT_NEAR(tracked[4], truth[4], 1e-13) << sample;
    EXPECT_NEAR(tracked[5], -0.7, 1e-10) << sample;
  }
}

TEST(SixRTrack, Theta4RestsInTheZoneOfTheWristSingularity) {
  const ArmGeometry geometry = test::kr6_r900();
  const SixR arm{geometry};
  for (const double centre : {0.0, kPi}) {
    for (const double away : {0.9e-7, -0.9e-7, 1e-12, 0.0}) {
      const Theta truth{0.3, 1.2, 0.4, 1.0, centre + away, -0.7};
      Theta previous = truth;
      previous[3] = 0.3 + 2.0 * kPi;
      previous[5] = truth[5];
      const Transform pose = arm.forward(truth);
      const RawTracking tracking = arm.track(pose, previous);
      EXPECT_EQ(tracking.status, IkStatus::kSingular);
      EXPECT_EQ(tracking.singular, kWristSingular);
      EXPECT_NEAR(tracking.theta[3], previous[3], 1e-15) << "to the turn";
      EXPECT_LT(test::rotation_error(arm.forward(tracking.theta), pose), 1e-7);
      EXPECT_LT(test::position_error_mm(arm.forward(tracking.theta), pose), 1e-7 * geometry.d6_mm + 1e-9);
    }
    const Theta outside{0.3, 1.2, 0.4, 1.0, centre + 1.1e-7, -0.7};
    const RawTracking tracking = arm.track(arm.forward(outside), outside);
    EXPECT_EQ(tracking.status, IkStatus::kOk);
    EXPECT_NEAR(tracking.theta[3], 1.0, 1e-7);
  }
}

TEST(SixRTrack, DoesNotJumpToTheOtherShoulderWhenThisOneCannotReach) {
  const ArmGeometry geometry = test::lrmate200id();
  const SixR arm{geometry};
  // Behind the arm: the front shoulder sits a1 on the far side.
  const double beyond_mm = 10.0;
  Transform pose{rotation_from_rpy(0.1, 0.2, 0.3), {}};
  const double front_to_wrist = test::reach_mm(geometry) + beyond_mm;
  pose.position_mm =
      Eigen::Vector3d{geometry.a1_mm - front_to_wrist, 0.0, geometry.d1_mm} + geometry.d6_mm * pose.rotation.col(2);
  const RawTracking lost = arm.track(pose, Theta{0.01, kPi, kPi / 2, 0.4, 0.5, 0.6});
  EXPECT_EQ(lost.status, IkStatus::kUnreachable);
  EXPECT_NEAR(lost.margin_mm, beyond_mm, 1e-9);
  EXPECT_EQ(arm.inverse(pose, Theta{}).count, 4u) << "the other one does";
  EXPECT_EQ(arm.track(pose, Theta{kPi - 0.01, 0.0, kPi / 2, 0.4, 0.5, 0.6}).status, IkStatus::kOk);
}

TEST(SixRTrack, ClampsAtTheReachLimitAndSaysSo) {
  const ArmGeometry geometry = test::irb120_geometry();
  const SixR arm{geometry};
  Transform pose{rotation_from_rpy(0.1, kPi / 2 - 0.2, 0.3), {}};
  const double distance = test::reach_mm(geometry) * (1.0 + 5e-10);
  pose.position_mm =
      Eigen::Vector3d{0.8 * distance, 0.0, geometry.d1_mm + 0.6 * distance} + geometry.d6_mm * pose.rotation.col(2);
  const double phi = std::atan2(geometry.d4_mm, geometry.a3_mm);
  const RawTracking tracking = arm.track(pose, Theta{0.0, std::atan2(0.6, 0.8), phi, 0.0, 0.5, 0.0});
  EXPECT_EQ(tracking.status, IkStatus::kClamped);
  EXPECT_EQ(tracking.singular & kElbowSingular, kElbowSingular);
  EXPECT_NEAR(tracking.theta[2], phi, 1e-12);
}

}  // namespace
}  // namespace armature
