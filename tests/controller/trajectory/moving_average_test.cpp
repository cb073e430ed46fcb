// The moving average of a law, and the plateaus that it needs, against S-curves and integrals.
#include "controller/trajectory/law/moving_average.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/law/plateaus.hpp"
#include "controller/trajectory/profile/scurve.hpp"

namespace armature {
namespace {

constexpr double kTopSpeed = 0.4, kTopAccel = 2.0;

// A law of constant limits over 0..length, with a stop at `stop`.
std::unique_ptr<SpeedLaw> law_over(double length, double stop, double jerk) {
  auto law = std::make_unique<SpeedLaw>();
  LawLimits limits;
  limits.bands[0].by_accel = 1.0 / kTopAccel;
  limits.most_square = kTopSpeed * kTopSpeed;
  limits.jerk.by_change = 1.0 / jerk;
  law->append(0.0, limits);
  if (stop > 0.0) law->append(stop, limits, true);
  law->append(length, limits);
  law->plan();
  return law;
}

TEST(MovingAverage, OfATrapezoidIsTheSCurve) {
  const double tau_s = 0.05, jerk = kTopAccel / tau_s;
  const auto law = law_over(1.0, 0.0, jerk);
  TimeTable trapezoid, smooth;
  trapezoid.assign(*law);
  const std::array tau{Ticks{1'000}};
  moving_average(trapezoid, tau, smooth);
  const SCurveProfile expected = plan_scurve(1.0, {.speed = kTopSpeed, .accel = kTopAccel, .jerk = jerk});
  ASSERT_NEAR(seconds(smooth.duration()), expected.duration_s, 1.1 * kTickSeconds);
  // The trapezoid takes whole ticks.
  const double slower = seconds(smooth.duration()) / expected.duration_s;
  for (double t_s = 0.0; t_s <= seconds(smooth.duration()); t_s += 1e-3) {
    EXPECT_NEAR(smooth.position(t_s), position(expected, t_s / slower), 3e-5) << t_s;
  }
  EXPECT_EQ(smooth.position(1e9), 1.0);
}

TEST(MovingAverage, IsTheMeanOverTauAndRestsAtStops) {
  const auto law = law_over(1.0, 0.3, 1e9);
  TimeTable plain, smooth;
  plain.assign(*law);
  const std::array tau{Ticks{400}, Ticks{}};
  moving_average(plain, tau, smooth);
  ASSERT_EQ(smooth.duration(), plain.duration() + Ticks{400});
  const double stop_s = plain.time_at(0.3), tau_s = 0.02;
  EXPECT_NEAR(smooth.position(stop_s + tau_s), 0.3, 1e-12);
  for (double t_s = 0.0; t_s <= stop_s + tau_s; t_s += 0.013) {
    long double sum = 0.0L;
    constexpr int kParts = 4'000;
    for (int i = 0; i < kParts; ++i) {
      const double at_s = t_s - tau_s * (i + 0.5) / kParts;
      sum += at_s < stop_s ? plain.position(at_s) : 0.3;
    }
    EXPECT_NEAR(smooth.position(t_s), static_cast<double>(sum / kParts), 1e-9) << t_s;
  }
  for (double t_s = stop_s; t_s <= seconds(plain.duration()); t_s += 0.013) {
    EXPECT_NEAR(smooth.position(t_s + tau_s), plain.position(t_s), 1e-12) << t_s;
  }
}

// The law goes on from `joint`, a point of the motion of `table`, to `end`.
std::unique_ptr<SpeedLaw> law_behind(const TimeTable::Point& joint, double end, double jerk) {
  auto law = law_over(end - joint.s, 0.0, jerk);
  const LawLimits limits = law->limits(0);
  law->clear();
  law->append(joint.s, limits);
  law->append(end, limits);
  law->start_with(joint.speed * joint.speed);
  law->plan();
  return law;
}

TEST(MovingAverage, IsContinuedInMotion) {
  const Ticks tau{400}, origin{1'000};
  const double tau_s = seconds(tau), origin_s = seconds(origin);
  const auto law = law_over(1.0, 0.0, 1e9);
  TimeTable plain, smooth;
  plain.assign(*law);
  moving_average(plain, std::array{tau}, smooth);
  const TimeTable before = smooth;
  const TimeTable::Point joint = plain.passing(0.975);  // the law brakes there
  const TimeTable::Point end{.t_s = joint.t_s,
                             .s = smooth.position(joint.t_s),
                             .speed = average_speed(plain, run_from(plain, 0), tau, joint.t_s)};
  plain.keep(joint.t_s - tau_s, joint, origin);
  smooth.keep(joint.t_s - 0.001, end, origin);
  plain.continue_with(*law_behind(joint, 2.0, 1e9));
  for (int repeated = 0; repeated < 2; ++repeated) continue_average(plain, tau, smooth);
  ASSERT_EQ(smooth.duration(), plain.duration() + tau);
  const double joint_s = joint.t_s - origin_s;
  for (double t_s = joint_s - 0.001; t_s <= joint_s; t_s += 1e-4) {
    EXPECT_NEAR(smooth.position(t_s), before.position(t_s + origin_s), 1e-12) << t_s;
  }
  for (double t_s = joint_s; t_s <= seconds(smooth.duration()); t_s += 0.0131) {
    long double sum = 0.0L;
    constexpr int kParts = 4'000;
    for (int i = 0; i < kParts; ++i) sum += plain.position(t_s - tau_s * (i + 0.5) / kParts);
    EXPECT_NEAR(smooth.position(t_s), static_cast<double>(sum / kParts), 1e-9) << t_s;
  }
  EXPECT_EQ(smooth.position(1e9), 2.0);
}

TEST(Plateaus, CutAPeakSoThatItLastsForTau) {
  const double tau_s = 0.05;
  const auto law = law_over(0.02, 0.0, kTopAccel / tau_s);  // a triangle
  TimeTable table;
  table.assign(*law);
  Plateaus plateaus;
  plateaus.find(table, run_from(table, 0), tau_s, *law);
  ASSERT_EQ(plateaus.size(), 1u);
  const Plateau& cut = plateaus[0];
  EXPECT_NEAR((cut.to - cut.from) / std::sqrt(cut.square), tau_s, 1e-6);
  EXPECT_NEAR(cut.from + cut.to, 0.02, 1e-9);
  const double before_s = seconds(table.duration());
  law->cap(cut.from, cut.to, cut.square);
  law->plan();
  table.assign(*law);
  EXPECT_NEAR(seconds(table.duration()), before_s + cut.longer_s, 2.0 * kTickSeconds);
  plateaus.find(table, run_from(table, 0), tau_s, *law);
  EXPECT_EQ(plateaus.size(), 0u);
}

TEST(Plateaus, FillAValleySoThatItLastsForTau) {
  const double tau_s = 0.05;
  auto law = std::make_unique<SpeedLaw>();
  LawLimits limits;
  limits.bands[0].by_accel = 1.0 / kTopAccel;
  limits.most_square = kTopSpeed * kTopSpeed;
  limits.jerk.by_change = tau_s / kTopAccel;
  LawLimits slow = limits;
  slow.most_square = 0.01;  // at one place
  law->append(0.0, limits);
  law->append(0.499'999, limits);
  law->append(0.5, slow);
  law->append(0.500'001, limits);
  law->append(1.0, limits);
  law->plan();
  TimeTable table;
  table.assign(*law);
  Plateaus plateaus;
  plateaus.find(table, run_from(table, 0), tau_s, *law);
  ASSERT_EQ(plateaus.size(), 1u);
  EXPECT_NEAR(plateaus[0].square, 0.01, 1e-9);
  EXPECT_NEAR(plateaus[0].to - plateaus[0].from, 0.1 * tau_s, 1e-5);
  law->cap(plateaus[0].from, plateaus[0].to, plateaus[0].square);
  law->plan();
  table.assign(*law);
  plateaus.find(table, run_from(table, 0), tau_s, *law);
  EXPECT_EQ(plateaus.size(), 0u);
}

TEST(Plateaus, KeepTheSpeedAtAJoint) {
  const double tau_s = 0.05;
  const auto law = law_over(1.0, 0.0, kTopAccel / tau_s);
  TimeTable table;
  table.assign(*law);
  const TimeTable::Point joint = table.passing(0.01);  // the law speeds up there
  ASSERT_NEAR(joint.speed, 0.2, 1e-9);
  table.keep(0.0, joint, Ticks{});
  // It stops soon, so a plateau of tau would need a slower one.
  const auto behind = law_behind(joint, 0.0225, kTopAccel / tau_s);
  table.continue_with(*behind);
  Plateaus plateaus;
  plateaus.find(table, run_from(table, 0), tau_s, *behind, &joint);
  ASSERT_EQ(plateaus.size(), 1u);
  EXPECT_EQ(plateaus[0].from, joint.s);
  EXPECT_DOUBLE_EQ(plateaus[0].square, joint.speed * joint.speed);
  EXPECT_GT(plateaus[0].to, joint.s);
  EXPECT_LT(plateaus[0].to, 0.0225);
}

}  // namespace
}  // namespace armature
