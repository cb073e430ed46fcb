#include "controller/trajectory/state/axis_reach.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/axis_draws.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/farthest_bound.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::AxisDraw;
using test::draw_within;
using test::draws;
using test::logarithmic;
using test::released;
using test::text_of;

class AxisReachProperties : public testing::TestWithParam<ProfileKind> {};

TEST_P(AxisReachProperties, NoMotionWithinTheLimitsIsFaster) {
  constexpr std::uint64_t kSeed = 20211121;
  test::Random random{kSeed};
  int proved = 0;
  for (int draw = 0; draw < draws(30'000); ++draw) {
    const AxisDraw d = draw_within(random, GetParam());
    const AxisReach reach{GetParam(), d.start, d.limits};
    const double duration_s = reach.shortest_s(d.target);
    ASSERT_GE(duration_s, reach.stop_s()) << "seed " << kSeed << " draw " << draw << ": " << text_of(d);
    // The stop is a lower bound too.
    if (duration_s <= reach.stop_s() + 0.1 * kTickSeconds) continue;
    const PhaseLaw law = reach.motion(d.target, duration_s).law;
    const double sign = d.target < reach.stop_position() ? -1.0 : 1.0;
    const test::FarthestBound bound = test::farthest_bound(GetParam(), law, d.start, 0.0, sign, d.limits);
    const long double beyond = bound.position - static_cast<long double>(sign) * d.target;
    const double rounding = 1e-14 * (std::fabs(d.start.position) + std::fabs(d.target));
    ASSERT_LE(static_cast<double>(beyond), 0.1 * kTickSeconds * static_cast<double>(bound.slope) + rounding)
        << "seed " << kSeed << " draw " << draw << ": " << text_of(d);
    // A bound below the target would be no bound.
    ASSERT_GE(static_cast<double>(beyond), -1e-11 * (1.0 + d.limits.speed * duration_s))
        << "seed " << kSeed << " draw " << draw << ": " << text_of(d);
    ++proved;
  }
  EXPECT_GT(proved, draws(25'000));
}

// Whole ticks, from the shortest possible to much longer.
Ticks draw_ticks(test::Random& random, double shortest_s) {
  const double ticks = std::ceil(shortest_s / kTickSeconds);
  const auto special = random.integer(0, 3);
  const double factor = special == 0 ? 1.0 : logarithmic(random, 1.0, special == 1 ? 1.1 : 5.0);
  return Ticks{static_cast<std::int64_t>(std::ceil(ticks * factor))};
}

TEST_P(AxisReachProperties, EverySetPointIsWithinTheLimitsAndTheLastOneIsTheTarget) {
  constexpr std::uint64_t kSeed = 17;
  constexpr double kTick2 = kTickSeconds * kTickSeconds, kTick3 = kTick2 * kTickSeconds;
  const bool with_jerk = GetParam() == ProfileKind::kSCurve;
  test::Random random{kSeed};
  for (int draw = 0; draw < draws(1'000); ++draw) {
    const AxisDraw d = draw_within(random, GetParam());
    const AxisReach reach{GetParam(), d.start, d.limits};
    const Ticks ticks = draw_ticks(random, reach.shortest_s(d.target));
    const auto [law, miss] = reach.motion(d.target, seconds(ticks));
    SCOPED_TRACE("seed 17 draw " + std::to_string(draw) + " ticks " + std::to_string(ticks.value()) + ": " +
                 text_of(d));
    const double size = 3.0 + d.limits.speed * seconds(ticks);
    ASSERT_LE(miss, 1e-13 * size);
    ASSERT_LE(law.duration_s(), seconds(ticks) + 1e-6 * kTickSeconds);
    ASSERT_EQ(law.at(0.0).position, d.start.position);
    ASSERT_EQ(law.at(0.0).velocity, law.duration_s() > 0.0 ? d.start.velocity : 0.0);
    ASSERT_EQ(law.at(seconds(ticks) + 1e-6 * kTickSeconds).position, d.target);
    // The last set-points, q[0] is the newest, and the largest of each difference.
    double q[4] = {}, speed = 0.0, accel = 0.0, jerk = 0.0, least = d.start.position, largest = least;
    for (std::int64_t k = 0; k <= ticks.value() + 3; ++k) {
      std::copy_backward(q, q + 3, q + 4);
      q[0] = law.at(seconds(Ticks{k})).position;
      least = std::min(least, q[0]);
      largest = std::max(largest, q[0]);
      if (k >= 1) speed = std::max(speed, std::fabs(q[0] - q[1]));
      if (k >= 2) accel = std::max(accel, std::fabs(q[0] - 2 * q[1] + q[2]));
      if (k >= 3) jerk = std::max(jerk, std::fabs(q[0] - 3 * q[1] + 3 * q[2] - q[3]));
    }
    const double rounding = 2e-15 * size, share = 1.0 + 3e-6;
    const double most_speed = std::max(d.limits.speed, std::fabs(d.start.velocity));
    ASSERT_LE(speed, most_speed * kTickSeconds * share + rounding);
    ASSERT_LE(accel, d.limits.accel * kTick2 * share + 4 * rounding);
    if (with_jerk) {
      ASSERT_LE(jerk, d.limits.jerk * kTick3 * share + 8 * rounding);
    }
    const auto extent = law.extent();
    ASSERT_GE(least, extent.least - rounding);
    ASSERT_LE(largest, extent.largest + rounding);
    // Between two set-points it can go a little farther.
    const double between = most_speed * kTickSeconds;
    ASSERT_LE(least, extent.least + between);
    ASSERT_GE(largest, extent.largest - between);
  }
}

// With time in hand an axis does not overshoot, and it never turns round more often than it must.
TEST_P(AxisReachProperties, ItStaysBetweenStartStopAndTarget) {
  test::Random random{5};
  for (int draw = 0; draw < draws(20'000); ++draw) {
    const AxisDraw d = draw_within(random, GetParam());
    const AxisReach reach{GetParam(), d.start, d.limits};
    const double shortest_s = reach.shortest_s(d.target);
    const auto [law, miss] = reach.motion(d.target, shortest_s * logarithmic(random, 1.0, 10.0));
    SCOPED_TRACE("seed 5 draw " + std::to_string(draw) + ": " + text_of(d));
    const PhaseLaw stop = reach.motion(reach.stop_position(), reach.stop_s()).law;
    const auto [least, largest] = law.extent();
    const auto [stop_least, stop_largest] = stop.extent();
    ASSERT_GE(least, std::min(stop_least, d.target) - 1e-12 * (3.0 + d.limits.speed * law.duration_s()));
    ASSERT_LE(largest, std::max(stop_largest, d.target) + 1e-12 * (3.0 + d.limits.speed * law.duration_s()));
  }
}

TEST_P(AxisReachProperties, AStateOnTheMotionIsThatOfItsLaw) {
  test::Random random{8};
  for (int draw = 0; draw < draws(20'000); ++draw) {
    const AxisDraw d = draw_within(random, GetParam());
    const AxisReach reach{GetParam(), d.start, d.limits};
    const double duration_s = reach.shortest_s(d.target) * logarithmic(random, 1.0, 10.0);
    const double t_s = duration_s * random.real(-0.1, 1.2);
    const AxisState wanted = reach.motion(d.target, duration_s).law.at(t_s);
    const AxisState found = reach.on_motion(d.target, duration_s, t_s);
    SCOPED_TRACE("seed 8 draw " + std::to_string(draw) + ": " + text_of(d));
    ASSERT_EQ(found.position, wanted.position);
    ASSERT_EQ(found.velocity, wanted.velocity);
    ASSERT_EQ(found.accel, wanted.accel);
  }
}

TEST_P(AxisReachProperties, FromRestItTakesAsLongAsTheProfilesDo) {
  test::Random random{6};
  for (int draw = 0; draw < draws(20'000); ++draw) {
    AxisDraw d = draw_within(random, GetParam());
    d.start.velocity = d.start.accel = 0.0;
    const double duration_s = AxisReach{GetParam(), d.start, d.limits}.shortest_s(d.target);
    const TimeLaw law = plan_time_law(GetParam(), d.target - d.start.position, d.limits);
    ASSERT_NEAR(duration_s, law.duration_s(), 1e-12 * law.duration_s()) << "seed 6 draw " << draw << ": " << text_of(d);
  }
}

// Replans in the middle of the fastest motion: what is left of it is the fastest motion from there.
TEST_P(AxisReachProperties, APartOfAFastestMotionIsAFastestMotion) {
  test::Random random{7};
  for (int draw = 0; draw < draws(20'000); ++draw) {
    const AxisDraw d = draw_within(random, GetParam());
    const PhaseLaw whole = plan_to_rest(GetParam(), d.start, d.target, d.limits);
    const double at_s = random.real(0.0, 1.0) * whole.duration_s();
    const double left_s = AxisReach{GetParam(), whole.at(at_s), d.limits}.shortest_s(d.target);
    // In the final stop the duration contains the third root of a rounding error.
    const double stop = AxisReach{GetParam(), whole.at(at_s), d.limits}.stop_position();
    const double tolerance_s = std::fabs(d.target - stop) > 1e-6 ? 1e-3 * kTickSeconds : 2.0 * kTickSeconds;
    ASSERT_NEAR(left_s, whole.duration_s() - at_s, tolerance_s) << "seed 7 draw " << draw << ": " << text_of(d);
  }
}

TEST_P(AxisReachProperties, AStartBeyondALimitReturnsIntoItWithoutDelay) {
  test::Random random{8};
  for (int draw = 0; draw < draws(20'000); ++draw) {
    AxisDraw d = draw_within(random, GetParam());
    d.start.velocity = random.real(-4.0, 4.0) * d.limits.speed;
    d.start.accel = random.real(-4.0, 4.0) * d.limits.accel;
    const PhaseLaw law = plan_to_rest(GetParam(), d.start, d.target, d.limits);
    SCOPED_TRACE("seed 8 draw " + std::to_string(draw) + ": " + text_of(d));
    const double end_s = law.duration_s();
    ASSERT_TRUE(end_s >= 0.0 && std::isfinite(end_s));
    bool inside = false;
    for (int i = 0; i <= 200; ++i) {
      const AxisState now = law.at(end_s * i / 200);
      const double speed = std::fabs(released(GetParam(), now, d.limits)), limit = d.limits.speed;
      if (speed <= limit * (1.0 + 1e-9)) inside = true;
      if (inside) {
        ASSERT_LE(speed, limit * (1.0 + 1e-9)) << "at " << i;
      } else if (std::fabs(now.accel) <= d.limits.accel * (1.0 + 1e-9)) {
        // Brakes, or increases its braking.
        const double braking = -now.accel * (released(GetParam(), now, d.limits) < 0.0 ? -1.0 : 1.0);
        const double later =
            -law.at(end_s * i / 200 + 1e-9).accel * (released(GetParam(), now, d.limits) < 0.0 ? -1.0 : 1.0);
        ASSERT_TRUE(later > braking || braking >= d.limits.accel * (1.0 - 1e-9)) << "at " << i;
      } else {
        ASSERT_LT(std::fabs(law.at(end_s * i / 200 + 1e-9).accel), std::fabs(now.accel)) << "at " << i;
      }
    }
    ASSERT_TRUE(inside);
    ASSERT_EQ(law.at(end_s).position, d.target);
  }
}

TEST_P(AxisReachProperties, AnyVelocityIsReachedWithoutOvershootAndThenKept) {
  test::Random random{9};
  for (int draw = 0; draw < draws(20'000); ++draw) {
    const AxisDraw d = draw_within(random, GetParam());
    const double velocity = random.integer(0, 5) == 0 ? 0.0 : random.real(-1.0, 1.0) * d.limits.speed;
    const PhaseLaw law = plan_to_velocity(GetParam(), d.start, velocity, d.limits);
    SCOPED_TRACE("seed 9 draw " + std::to_string(draw) + ": " + text_of(d));
    const AxisState end = law.end();
    const double shortest_s = std::fabs(velocity - d.start.velocity) / d.limits.accel;
    ASSERT_GE(law.duration_s(), shortest_s * (1.0 - 1e-12));
    ASSERT_EQ(end.velocity, velocity);
    const AxisState just_before = law.at(law.duration_s() * (1.0 - 1e-12));
    ASSERT_NEAR(just_before.velocity, velocity, 1e-9 * d.limits.speed);
    ASSERT_NEAR(law.at(law.duration_s() + 2.0).position, end.position + 2.0 * velocity, 1e-12);
    ASSERT_LE(law.peak_speed(), d.limits.speed * (1.0 + 1e-12));
    for (int i = 0; i <= 50; ++i) {
      const AxisState now = law.at(law.duration_s() * i / 50);
      ASSERT_LE(std::fabs(now.accel), d.limits.accel * (1.0 + 1e-12));
    }
  }
}

// The fastest change of the velocity under limited acceleration and jerk, by bisection of its largest acceleration.
long double ramp_s(long double v, long double a, long double V, long double A, long double J) {
  const long double direct = a * std::fabs(a) / (2 * J) + v;
  const long double sign = direct > V ? -1.0L : 1.0L;
  v *= sign, a *= sign, V *= sign;
  long double low = std::fmax(a, 0.0L), high = A;
  const auto gained = [&](long double peak) { return (peak * peak - a * a / 2) / J; };
  if (v + gained(A) <= V) return (2 * A - a) / J + (V - v - gained(A)) / A;
  for (int i = 0; i < 200; ++i) {
    const long double middle = (low + high) / 2;
    (v + gained(middle) < V ? low : high) = middle;
  }
  return (2 * low - a) / J;
}

TEST(AxisReach, AStopIsTheFastestChangeToRest) {
  test::Random random{10};
  for (int draw = 0; draw < draws(20'000); ++draw) {
    const AxisDraw d = draw_within(random, ProfileKind::kSCurve);
    const AxisReach reach{ProfileKind::kSCurve, d.start, d.limits};
    const long double expected_s = ramp_s(d.start.velocity, d.start.accel, 0, d.limits.accel, d.limits.jerk);
    ASSERT_NEAR(reach.stop_s(), static_cast<double>(expected_s), 1e-3 * kTickSeconds)
        << "seed 10 draw " << draw << ": " << text_of(d);
  }
}

TEST(AxisReach, AtRestAtTheTargetThereIsNothingToDo) {
  for (const ProfileKind kind : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    const AxisReach reach{kind, {.position = 1.25}, {.speed = 1.0, .accel = 2.0, .jerk = 3.0}};
    EXPECT_EQ(reach.stop_position(), 1.25);
    EXPECT_EQ(reach.shortest_s(1.25), 0.0);
    const PhaseLaw law = reach.motion(1.25, 1.0).law;
    EXPECT_EQ(law.duration_s(), 0.0);
    EXPECT_EQ(law.at(0.5).position, 1.25);
    EXPECT_EQ(law.at(0.5).velocity, 0.0);
    // An axis without a drive has no limits.
    EXPECT_EQ((AxisReach{kind, {}, {}}.shortest_s(0.0)), 0.0);
    EXPECT_EQ((AxisReach{kind, {}, {}}.motion(0.0, 1.0).law.at(0.5).position), 0.0);
  }
}

TEST(AxisReach, IsFiniteForTheLeastDistancesAndAnySizeOfLimits) {
  test::Random random{11};
  for (int draw = 0; draw < draws(100'000); ++draw) {
    const ProfileKind kind = random.integer(0, 1) == 0 ? ProfileKind::kTrapezoid : ProfileKind::kSCurve;
    const TimeLawLimits limits{.speed = logarithmic(random, 1e-6, 1e6),
                               .accel = logarithmic(random, 1e-6, 1e6),
                               .jerk = logarithmic(random, 1e-6, 1e9)};
    AxisState start{0.0, random.real(-2.0, 2.0) * limits.speed, random.real(-2.0, 2.0) * limits.accel};
    if (random.integer(0, 2) == 0) start.velocity *= logarithmic(random, 1e-300, 1.0);
    if (random.integer(0, 2) == 0) start.accel *= logarithmic(random, 1e-300, 1.0);
    if (random.integer(0, 3) == 0) start.velocity = 0.0;
    if (random.integer(0, 3) == 0) start.accel = 0.0;
    const AxisReach reach{kind, start, limits};
    const double target = (random.integer(0, 1) == 0 ? reach.stop_position() : 0.0) +
                          random.real(-1.0, 1.0) * logarithmic(random, 1e-300, 1e3);
    const double shortest_s = reach.shortest_s(target);
    SCOPED_TRACE("seed 11 draw " + std::to_string(draw));
    ASSERT_TRUE(std::isfinite(shortest_s));
    ASSERT_GE(shortest_s, reach.stop_s());
    const PhaseLaw law = reach.motion(target, shortest_s * random.real(1.0, 3.0)).law;
    for (int i = 0; i <= 20; ++i) {
      const AxisState now = law.at(law.duration_s() * i / 20);
      ASSERT_TRUE(std::isfinite(now.position) && std::isfinite(now.velocity) && std::isfinite(now.accel));
    }
    ASSERT_EQ(law.at(law.duration_s()).position, target);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, AxisReachProperties, testing::Values(ProfileKind::kTrapezoid, ProfileKind::kSCurve),
                         [](const auto& kind) {
                           return std::string{kind.param == ProfileKind::kSCurve ? "Scurve" : "Trapezoid"};
                         });

}  // namespace
}  // namespace armature
