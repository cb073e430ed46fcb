#include "controller/trajectory/profile/scurve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

struct SCurveCase {
  double distance = 0.0;
  SCurveLimits limits{};
};

std::ostream& operator<<(std::ostream& out, const SCurveCase& c) {
  return out << std::hexfloat << "distance " << c.distance << " speed " << c.limits.speed << " accel " << c.limits.accel
             << " jerk " << c.limits.jerk;
}

double decades(test::Random& random, double least, double most) {
  return std::pow(10.0, random.real(least, most));
}

// All four independently over many decades: every combination of limits that bind and do not.
SCurveCase random_scurve_case(test::Random& random) {
  SCurveCase c;
  c.distance = decades(random, -9.0, 6.0) * (random.integer(0, 1) == 0 ? 1.0 : -1.0);
  c.limits.speed = decades(random, -4.0, 4.0);
  c.limits.accel = decades(random, -3.0, 6.0);
  c.limits.jerk = decades(random, -2.0, 8.0);
  return c;
}

// Ends of the seven phases, from 0.
std::array<double, 8> borders(const SCurveProfile& p) {
  std::array<double, 8> t{};
  const std::array<double, 7> phases{p.jerk_s, p.hold_s, p.jerk_s, p.cruise_s, p.jerk_s, p.hold_s, p.jerk_s};
  for (std::size_t i = 0; i < phases.size(); ++i) t[i + 1] = t[i] + phases[i];
  return t;
}

// Time of the ramp from rest to `speed`.
double ramp_to(double speed, double accel, double jerk) {
  return speed * jerk >= accel * accel ? speed / accel + accel / jerk : 2.0 * std::sqrt(speed / jerk);
}

struct Known {
  SCurveCase input;
  double jerk_s, hold_s, cruise_s, peak_speed, peak_accel;
};

TEST(Scurve, TakesTheTimesThatPencilAndPaperGive) {
  for (const Known& k : {Known{{10.0, {1.0, 1.0, 2.0}}, 0.5, 0.5, 8.5, 1.0, 1.0},     // every limit
                         Known{{-4.0, {1.0, 5.0, 1.0}}, 1.0, 0.0, 2.0, 1.0, 1.0},     // speed, jerk
                         Known{{6.0, {100.0, 1.0, 1.0}}, 1.0, 1.0, 0.0, 2.0, 1.0},    // acceleration, jerk
                         Known{{2.0, {100.0, 100.0, 1.0}}, 1.0, 0.0, 0.0, 1.0, 1.0},  // jerk
                         Known{{1.5, {1.0, 1.0, 2.0}}, 0.5, 0.5, 0.0, 1.0, 1.0}}) {   // speed just reached
    SCOPED_TRACE(testing::Message() << k.input);
    const SCurveProfile p = plan_scurve(k.input.distance, k.input.limits);
    EXPECT_EQ(p.shape, ProfileShape::kSCurve);
    EXPECT_NEAR(p.jerk_s, k.jerk_s, 1e-15);
    EXPECT_NEAR(p.hold_s, k.hold_s, 1e-15);
    EXPECT_NEAR(p.cruise_s, k.cruise_s, 1e-14);
    EXPECT_NEAR(p.peak_speed, k.peak_speed, 1e-15);
    EXPECT_NEAR(p.peak_accel, k.peak_accel, 1e-15);
    EXPECT_EQ(p.jerk, k.input.limits.jerk);
    EXPECT_NEAR(p.duration_s, 4.0 * k.jerk_s + 2.0 * k.hold_s + k.cruise_s, 1e-14);
  }
}

TEST(Scurve, NoDistanceTakesNoTime) {
  for (const double zero : {0.0, -0.0}) {
    const SCurveProfile p = plan_scurve(zero, {});  // nor does it need limits
    EXPECT_EQ(p.shape, ProfileShape::kNone);
    EXPECT_EQ(p.duration_s, 0.0);
    for (const double t : {-1.0, 0.0, 0.5}) {
      EXPECT_EQ(position(p, t), 0.0);
      EXPECT_EQ(velocity(p, t), 0.0);
      EXPECT_EQ(acceleration(p, t), 0.0);
      EXPECT_EQ(jerk(p, t), 0.0);
    }
    EXPECT_EQ(time_at(p, 1.0), 0.0);
    EXPECT_EQ(scale_in_time(p, 2.0).duration_s, 2.0);
    EXPECT_EQ(position(scale_in_time(p, 2.0), 1.0), 0.0);
  }
}

// At the ends of all phases and at random times.
void expect_limits_are_kept(const SCurveCase& c, test::Random& random) {
  const SCurveProfile p = plan_scurve(c.distance, c.limits);
  const auto check = [&](double t) {
    ASSERT_LE(std::fabs(velocity(p, t)), c.limits.speed) << c << " t " << t;
    ASSERT_LE(std::fabs(acceleration(p, t)), c.limits.accel) << c << " t " << t;
    ASSERT_LE(std::fabs(jerk(p, t)), c.limits.jerk) << c << " t " << t;
    ASSERT_GE(velocity(p, t) * c.distance, 0.0) << c << " t " << t;
  };
  ASSERT_LE(p.peak_speed, c.limits.speed) << c;
  ASSERT_LE(p.peak_accel, c.limits.accel) << c;
  for (const double phase : {p.jerk_s, p.hold_s, p.cruise_s}) ASSERT_GE(phase, 0.0) << c;
  for (int i = 0; i < 20; ++i) ASSERT_NO_FATAL_FAILURE(check(random.real(-0.1, 1.1) * p.duration_s));
  for (const double t : borders(p)) ASSERT_NO_FATAL_FAILURE(check(t));
}

TEST(Scurve, NeverExceedsALimitNotEvenByARounding) {
  test::Random random{201};
  for (int draw = 0; draw < 10'000; ++draw) {
    ASSERT_NO_FATAL_FAILURE(expect_limits_are_kept(random_scurve_case(random), random)) << "seed 201 draw " << draw;
  }
}

// Where a limit is just reached or just not: the cases must agree, and their roundings must not pass the limit.
TEST(Scurve, NeverExceedsALimitWhereItsCasesMeet) {
  test::Random random{206};
  for (int draw = 0; draw < 2'000; ++draw) {
    SCurveCase c = random_scurve_case(random);
    auto& [speed, accel, jerk_limit] = c.limits;
    if (draw % 2 == 0) accel = std::sqrt(speed * jerk_limit);
    const double full_speed = speed * ramp_to(speed, accel, jerk_limit);
    const double full_accel = 2.0 * accel * (accel / jerk_limit) * (accel / jerk_limit);
    for (const double border : {full_speed, full_accel}) {
      const double duration_s = plan_scurve(border, c.limits).duration_s;
      for (int ulps = -4; ulps <= 4; ++ulps) {
        c.distance = border * (1.0 + ulps * 0x1p-52);
        ASSERT_NO_FATAL_FAILURE(expect_limits_are_kept(c, random)) << "seed 206 draw " << draw;
        ASSERT_NEAR(plan_scurve(c.distance, c.limits).duration_s, duration_s, 1e-14 * duration_s) << "seed 206 " << c;
      }
    }
  }
}

TEST(Scurve, ReachesTheLimitsThatBind) {
  test::Random random{202};
  std::array<int, 4> seen{};
  for (int draw = 0; draw < 20'000; ++draw) {
    const SCurveCase c = random_scurve_case(random);
    const SCurveProfile p = plan_scurve(c.distance, c.limits);
    const double q = std::fabs(c.distance);
    const auto& [speed, accel, jerk_limit] = c.limits;
    const double slack = 1.0 + 1e-12;
    ASSERT_EQ(p.jerk, jerk_limit);
    const bool speed_binds = speed * ramp_to(speed, accel, jerk_limit) * slack < q;
    const double peak = speed_binds ? speed : p.peak_speed;
    const bool accel_binds = peak * jerk_limit > accel * accel * slack;
    if (speed_binds) {
      ASSERT_EQ(p.peak_speed, speed) << "seed 202 draw " << draw << " " << c;
    }
    if (speed_binds) {
      ASSERT_GT(p.cruise_s, 0.0) << "seed 202 draw " << draw << " " << c;
    }
    if (accel_binds) {
      ASSERT_EQ(p.peak_accel, accel) << "seed 202 draw " << draw << " " << c;
    }
    if (accel_binds) {
      ASSERT_GT(p.hold_s, 0.0) << "seed 202 draw " << draw << " " << c;
    }
    ++seen[(speed_binds ? 2u : 0u) + (accel_binds ? 1u : 0u)];
  }
  for (const int count : seen) EXPECT_GT(count, 500) << "a case that the draw does not cover";
}

// The largest peak speed whose two ramps fit into the distance, by bisection.
TEST(Scurve, TakesAsLongAsTheLargestPeakSpeedThatFits) {
  test::Random random{203};
  for (int draw = 0; draw < 5'000; ++draw) {
    const SCurveCase c = random_scurve_case(random);
    const double q = std::fabs(c.distance);
    const auto& [limit, accel, jerk_limit] = c.limits;
    double low = 0.0, speed = limit;
    if (speed * ramp_to(speed, accel, jerk_limit) > q) {
      for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + speed);
        (middle * ramp_to(middle, accel, jerk_limit) > q ? speed : low) = middle;
      }
    }
    const double expected_s = ramp_to(speed, accel, jerk_limit) + q / speed;
    ASSERT_NEAR(plan_scurve(c.distance, c.limits).duration_s, expected_s, 1e-13 * expected_s)
        << "seed 203 draw " << draw << " " << c;
  }
}

// Challenged by profiles with other peaks and with another ramp at each end, all within the limits.
TEST(Scurve, NoOtherProfileWithinTheLimitsIsFaster) {
  test::Random random{204};
  int challenges = 0;
  for (int draw = 0; draw < 5'000; ++draw) {
    const SCurveCase c = random_scurve_case(random);
    const double q = std::fabs(c.distance);
    const SCurveProfile p = plan_scurve(c.distance, c.limits);
    for (int i = 0; i < 20; ++i) {
      // Half of the challengers differ from the best only by little.
      const double least = i % 2 == 0 ? 0.05 : 0.999;
      const auto share = [&] { return std::min(1.0, random.real(least, 1.0 + 0.3 * (1.0 - least))); };
      const double speed = std::min(c.limits.speed, p.peak_speed * random.real(least, 2.0 - least));
      const double up_accel = share() * c.limits.accel, up_jerk = share() * c.limits.jerk;
      const double down_accel = share() * c.limits.accel, down_jerk = share() * c.limits.jerk;
      const double ramps_s = ramp_to(speed, up_accel, up_jerk) + ramp_to(speed, down_accel, down_jerk);
      const double cruise_s = q / speed - 0.5 * ramps_s;
      if (cruise_s < 0.0) continue;
      ASSERT_GE(ramps_s + cruise_s, p.duration_s * (1.0 - 1e-13)) << "seed 204 draw " << draw << " " << c;
      ++challenges;
    }
  }
  EXPECT_GT(challenges, 20'000);
}

// Gauss' rule with two nodes is exact for the cubic that each phase holds, and its nodes are inside the phase.
TEST(Scurve, JerkIntegratesToAccelerationToSpeedToDistance) {
  test::Random random{205};
  for (int draw = 0; draw < 5'000; ++draw) {
    const SCurveCase c = random_scurve_case(random);
    const SCurveProfile p = plan_scurve(c.distance, c.limits);
    const auto t = borders(p);
    ASSERT_NEAR(t.back(), p.duration_s, 1e-14 * p.duration_s) << c;
    double accel = 0.0, speed = 0.0, covered = 0.0;
    for (std::size_t phase = 0; phase < 7; ++phase) {
      const double half = 0.5 * (t[phase + 1] - t[phase]), middle = t[phase] + half, to = t[phase + 1];
      if (!(half > 0.0)) continue;
      const double one = middle - half / std::sqrt(3.0), other = middle + half / std::sqrt(3.0);
      accel += (jerk(p, one) + jerk(p, other)) * half;
      speed += (acceleration(p, one) + acceleration(p, other)) * half;
      covered += (velocity(p, one) + velocity(p, other)) * half;
      // A border is a sum of phases: so many roundings of the whole duration away.
      const double border = 1e-15 * p.duration_s;
      ASSERT_NEAR(acceleration(p, to), accel, 1e-12 * p.peak_accel + border * p.jerk)
          << "seed 205 " << draw << " " << c;
      ASSERT_NEAR(velocity(p, to), speed, 1e-12 * p.peak_speed + border * p.peak_accel)
          << "seed 205 " << draw << " " << c;
      ASSERT_NEAR(position(p, to), covered, 1e-12 * p.distance) << "seed 205 " << draw << " " << c;
    }
    ASSERT_NEAR(covered, c.distance, 1e-12 * p.distance) << "seed 205 draw " << draw << " " << c;
  }
}

}  // namespace
}  // namespace armature
