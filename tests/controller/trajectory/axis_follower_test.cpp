// The set-points of an axis that follows a reference, judged by their differences alone.
#include "controller/trajectory/state/axis_follower.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/axis_draws.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::logarithmic;
using test::Random;

constexpr std::uint64_t kFollowerSeed = 1'000;
constexpr AxisFollower::Range kWide{-100.0, 100.0};

// Peaks of speed, acceleration and jerk, from differences of set-points. A mean over a tick never exceeds the peak.
struct DifferencePeaks {
  long double speed = 0, accel = 0, jerk = 0;
};

DifferencePeaks peaks_of(const std::vector<double>& positions) {
  DifferencePeaks peaks;
  const long double dt = kTickSeconds;
  const auto at = [&](std::size_t i) { return static_cast<long double>(positions[i]); };
  for (std::size_t i = 3; i < positions.size(); ++i) {
    peaks.speed = std::max(peaks.speed, std::fabs(at(i) - at(i - 1)) / dt);
    peaks.accel = std::max(peaks.accel, std::fabs(at(i) - 2 * at(i - 1) + at(i - 2)) / (dt * dt));
    peaks.jerk = std::max(peaks.jerk, std::fabs(at(i) - 3 * at(i - 1) + 3 * at(i - 2) - at(i - 3)) / (dt * dt * dt));
  }
  return peaks;
}

class AxisFollowerTest : public testing::TestWithParam<ProfileKind> {};

// References with jumps, corners and speeds far beyond the limits, and ends of the range in the way.
TEST_P(AxisFollowerTest, KeepsEveryLimitWhateverTheReferenceDoes) {
  Random random{kFollowerSeed};
  for (int run = 0; run < test::draws(60); ++run) {
    const TimeLawLimits limits{.speed = logarithmic(random, 0.1, 8.0),
                               .accel = logarithmic(random, 0.2, 50.0),
                               .jerk = logarithmic(random, 5.0, 2'000.0)};
    const AxisFollower::Range range{-random.real(0.01, 0.5), random.real(0.01, 0.5)};
    AxisFollower axis{GetParam(), limits, range, 0.0};
    std::vector<double> positions(4, 0.0);
    AxisState reference{};
    for (int tick = 0; tick < 6'000; ++tick) {
      const auto change = random.integer(0, 199);
      if (change == 0) reference.position += random.real(-0.2, 0.2);
      if (change == 1) reference.velocity = random.real(-2.0, 2.0) * limits.speed;
      if (change == 2) reference.velocity = 0.0;
      if (change == 3) reference.accel = random.real(-2.0, 2.0) * limits.accel;
      reference = after(reference, 0.0, kTickSeconds);
      if (std::fabs(reference.position) > 0.6) reference = {.position = std::clamp(reference.position, -0.6, 0.6)};
      axis.advance(reference);
      positions.push_back(axis.state().position);
      ASSERT_GE(axis.state().position, range.least - 1e-11) << "run " << run << ", tick " << tick;
      ASSERT_LE(axis.state().position, range.largest + 1e-11) << "run " << run << ", tick " << tick;
    }
    const DifferencePeaks peaks = peaks_of(positions);
    ASSERT_LE(peaks.speed, limits.speed * (1 + 1e-6)) << "run " << run;
    ASSERT_LE(peaks.accel, limits.accel * (1 + 1e-4) + 1e-6) << "run " << run;
    // 1e-16 / (50 us)^3 is 1e-3.
    if (GetParam() == ProfileKind::kTrapezoid) continue;
    ASSERT_LE(peaks.jerk, limits.jerk * 1.001 + 0.05) << "run " << run;
  }
}

TEST_P(AxisFollowerTest, IsExactlyOnAReferenceWithinItsLimits) {
  const TimeLawLimits limits{.speed = 2.0, .accel = 10.0, .jerk = 100.0};
  AxisFollower axis{GetParam(), limits, kWide, 0.0};
  const double rate = 4.0;  // 0.5 (1 - cos(rate t)): 2 rad/s at most, 8 rad/s^2, 32 rad/s^3
  for (int tick = 1; tick < 40'000; ++tick) {
    const double t_s = tick * kTickSeconds;
    const AxisState reference{.position = 0.45 * (1.0 - std::cos(rate * t_s)),
                              .velocity = 0.45 * rate * std::sin(rate * t_s),
                              .accel = 0.45 * rate * rate * std::cos(rate * t_s)};
    axis.advance(reference);
    // The acceleration of the start, 7.2 rad/s^2, takes 0.07 s with a jerk limit, and catching up about 0.5 s.
    if (GetParam() == ProfileKind::kSCurve && tick < 13'000) continue;
    ASSERT_NEAR(axis.state().position, reference.position, GetParam() == ProfileKind::kTrapezoid ? 0.0 : 1e-9)
        << "tick " << tick;
  }
}

TEST_P(AxisFollowerTest, ComesToRestAtAReferenceThatRestsNoLaterThanTheFastestMove) {
  Random random{kFollowerSeed};
  for (int run = 0; run < test::draws(60); ++run) {
    const TimeLawLimits limits{.speed = logarithmic(random, 0.1, 8.0),
                               .accel = logarithmic(random, 0.2, 50.0),
                               .jerk = logarithmic(random, 5.0, 2'000.0)};
    const double target = random.real(-1.0, 1.0);
    AxisFollower axis{GetParam(), limits, kWide, 0.0};
    const double shortest_s = AxisReach{GetParam(), {}, limits}.shortest_s(target);
    for (std::int64_t tick = static_cast<std::int64_t>(shortest_s / kTickSeconds) + 3; tick > 0; --tick) {
      axis.advance({.position = target});
    }
    ASSERT_EQ(axis.state().position, target) << "run " << run;
    ASSERT_TRUE(axis.state().at_rest()) << "run " << run;
  }
}

INSTANTIATE_TEST_SUITE_P(Profiles, AxisFollowerTest, testing::Values(ProfileKind::kTrapezoid, ProfileKind::kSCurve),
                         [](const auto& suite) {
                           return suite.param == ProfileKind::kSCurve ? "SCurve" : "Trapezoid";
                         });

}  // namespace
}  // namespace armature
