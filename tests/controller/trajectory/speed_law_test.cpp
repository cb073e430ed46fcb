// The law of the speed along a path against closed forms, and against the bound of a fine grid (law_oracle.hpp).
#include "controller/trajectory/law/speed_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/law/time_table.hpp"
#include "controller/trajectory/profile/synchronise.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/law_oracle.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::Random;
using LimitsAt = std::function<LawLimits(double)>;

LawLimits constant(double speed, double accel) {
  LawLimits limits;
  limits.bands[0] = {.by_accel = 1.0 / accel};
  limits.most_square = speed * speed;
  return limits;
}

// Half a megabyte each, so not on the stack.
struct LawRig {
  std::unique_ptr<SpeedLaw> law = std::make_unique<SpeedLaw>();
  std::unique_ptr<TimeTable> table = std::make_unique<TimeTable>();

  void plan(const LimitsAt& limits, double length, int intervals) {
    law->clear();
    for (int i = 0; i <= intervals; ++i) {
      const double s = length * i / intervals;
      ASSERT_TRUE(law->append(s, limits(s)));
    }
    law->plan();
  }
  [[nodiscard]] double duration_s() const {
    double result = 0.0;
    for (std::size_t i = 0; i + 1 < law->size(); ++i) {
      const double step = law->s(i + 1) - law->s(i);
      if (step > 0.0) result += 2.0 * step / (std::sqrt(law->square(i)) + std::sqrt(law->square(i + 1)));
    }
    return result;
  }
  [[nodiscard]] double accel(std::size_t i) const {
    return 0.5 * (law->square(i + 1) - law->square(i)) / (law->s(i + 1) - law->s(i));
  }
};

TEST(SpeedLaw, IsATrapezoidUnderConstantLimits) {
  LawRig rig;
  for (const int intervals : {1, 2, 7, 100}) {
    rig.plan([](double) { return constant(250.0, 3'000.0); }, 300.0, intervals);
    EXPECT_NEAR(rig.duration_s(), 300.0 / 250.0 + 250.0 / 3'000.0, 1e-9) << intervals;
  }
}

// It reaches its speed within a billionth of the path.
TEST(SpeedLaw, CruisesNearlyAllTheWayWhereItIsSlow) {
  LawRig rig;
  for (const int intervals : {1, 2, 7, 100}) {
    rig.plan([](double) { return constant(0.01, 1'000.0); }, 5.9, intervals);
    EXPECT_NEAR(rig.duration_s() / 590.0, 1.0, 2e-4) << intervals;
  }
}

TEST(SpeedLaw, IsATriangleOverAShortWay) {
  LawRig rig;
  for (const int intervals : {1, 2, 7, 100}) {
    // The last one could brake from its largest speed within its length.
    for (const double length : {4.0, 12.0, 20.0}) {
      rig.plan([](double) { return constant(250.0, 3'000.0); }, length, intervals);
      EXPECT_NEAR(rig.duration_s(), 2.0 * std::sqrt(length / 3'000.0), 1e-9) << intervals << " " << length;
    }
  }
}

TEST(SpeedLaw, StopsWhereAPointMustStop) {
  LawRig rig;
  rig.law->clear();
  for (const double s : {0.0, 50.0, 100.0, 150.0}) {
    ASSERT_TRUE(rig.law->append(s, constant(250.0, 3'000.0), s == 100.0));
  }
  rig.law->plan();
  EXPECT_NEAR(rig.duration_s(), 150.0 / 250.0 + 2.0 * 250.0 / 3'000.0, 1e-9);
}

TEST(SpeedLaw, SlowsDownOnlyWhereOneStretchIsSlow) {
  LawRig rig;
  const auto limits = [](bool slow) { return constant(slow ? 50.0 : 250.0, 3'000.0); };
  rig.law->clear();
  for (const auto& [s, slow] :
       {std::pair{0.0, false}, {100.0, false}, {100.0, true}, {110.0, true}, {110.0, false}, {300.0, false}}) {
    ASSERT_TRUE(rig.law->append(s, limits(slow)));
  }
  rig.law->plan();
  // Both ramps of the slow stretch lie outside of it.
  const double ramp_s = 200.0 / 3'000.0, ramp_mm = 0.5 * (250.0 + 50.0) * ramp_s;
  const double ends_s = 2.0 * 250.0 / 3'000.0, ends_mm = 250.0 * 250.0 / 3'000.0;
  EXPECT_NEAR(rig.duration_s(), 10.0 / 50.0 + 2.0 * ramp_s + ends_s + (290.0 - 2.0 * ramp_mm - ends_mm) / 250.0, 1e-9);
}

TEST(SpeedLaw, DividesTheAccelerationOfACircleBetweenItsTwoDirections) {
  // |a| <= A with a = (u, x / r): from rest u = sqrt(A^2 - (x/r)^2), x = r A sin(2 s / r).
  constexpr double kRadius = 20.0, kAccel = 1'000.0;
  const auto limits = [](double) {
    LawLimits result;
    result.ellipses[0] = {.accel2 = 1.0 / (kAccel * kAccel), .square2 = 1.0 / std::pow(kRadius * kAccel, 2)};
    result.most_square = 1e9;
    return result;
  };
  LawRig rig;
  const double length = 2.0 * std::numbers::pi * kRadius;
  rig.plan(limits, length, 400);
  for (std::size_t i = 0; i < rig.law->size(); ++i) {
    const double s = std::min(rig.law->s(i), length - rig.law->s(i));
    const double ideal = kRadius * kAccel * (s < 0.25 * std::numbers::pi * kRadius ? std::sin(2.0 * s / kRadius) : 1.0);
    EXPECT_NEAR(rig.law->square(i), ideal, 1e-2 * kRadius * kAccel) << s;
    EXPECT_LE(rig.law->square(i), ideal * (1.0 + 1e-3)) << s;
  }
}

// Limits that vary smoothly: two joints whose rates change their sign, and a tool on a bent path.
struct RandomPath {
  explicit RandomPath(Random& random) {
    for (double& a : amplitude) a = random.real(-2.0, 2.0);
    for (double& p : phase) p = random.real(0.0, 6.0);
    for (double& w : frequency) w = random.real(0.3, 3.0);
    speed = random.real(0.3, 3.0);
    tool_accel = random.real(0.5, 5.0);
  }
  [[nodiscard]] LawLimits operator()(double s) const {
    LawLimits limits;
    double most = speed * speed;
    for (std::size_t j = 0; j < 4; ++j) {
      const double at = frequency[j] * s + phase[j];
      const double rate = amplitude[j] * std::cos(at), bend = -amplitude[j] * frequency[j] * std::sin(at);
      limits.bands[j] = {.by_accel = rate / 2.0, .by_square = bend / 2.0};
      if (rate != 0.0) most = std::min(most, 1.0 / (rate * rate));
    }
    const double bend = 1.5 * std::sin(frequency[4] * s + phase[4]);
    limits.ellipses[0] = {.accel2 = 1.0 / (tool_accel * tool_accel),
                          .square2 = bend * bend / (tool_accel * tool_accel)};
    limits.most_square = most;
    return limits;
  }
  std::array<double, 5> amplitude{}, phase{}, frequency{};
  double speed, tool_accel;
};

TEST(SpeedLaw, IsAsFastAsTheBoundAndKeepsRandomLimitsBetweenItsPoints) {
  Random random{5};
  LawRig rig;
  constexpr int kFine = 8'000;
  constexpr double kLength = 6.0;
  for (int draw = 0; draw < test::draws(60); ++draw) {
    SCOPED_TRACE(draw);
    const RandomPath path{random};
    rig.plan(path, kLength, 300);
    std::vector<LawLimits> fine;
    for (int i = 0; i <= kFine; ++i) fine.push_back(path(kLength * i / kFine));
    const auto bound_s = static_cast<double>(test::least_duration_s(fine, static_cast<long double>(kLength) / kFine));
    EXPECT_LT(rig.duration_s(), 1.004 * bound_s);
    EXPECT_GT(rig.duration_s(), 0.996 * bound_s);

    for (std::size_t i = 0; i + 1 < rig.law->size(); ++i) {
      const double from = rig.law->s(i), step = rig.law->s(i + 1) - from, u = rig.accel(i);
      for (const double share : {0.0, 0.31, 0.5, 0.83, 1.0}) {
        const double x = rig.law->square(i) + 2.0 * u * share * step;
        // At the grid points exactly (where the law added one, its limits are interpolated), between them to the second
        // order of the grid.
        const bool at_end = share == 0.0 || share == 1.0;
        ASSERT_LE(test::oracle_share(path(from + share * step), u, x), at_end ? 1.005 : 1.02) << from << " " << share;
      }
    }
  }
}

TEST(SpeedLaw, IsTheSameInSlices) {
  Random random{6};
  const RandomPath path{random};
  LawRig whole, sliced;
  whole.plan(path, 6.0, 100);
  sliced.law->clear();
  for (int i = 0; i <= 100; ++i) ASSERT_TRUE(sliced.law->append(6.0 * i / 100, path(6.0 * i / 100)));
  sliced.law->begin();
  int slices = 1;
  while (sliced.law->work(7) == SpeedLaw::Progress::kWorking) ++slices;
  EXPECT_GT(slices, 25);
  ASSERT_EQ(sliced.law->size(), whole.law->size());
  for (std::size_t i = 0; i < whole.law->size(); ++i) EXPECT_EQ(sliced.law->square(i), whole.law->square(i));
}

TEST(SpeedLaw, IsLoweredOnlyWhereItMustBe) {
  LawRig rig;
  rig.plan([](double) { return constant(250.0, 3'000.0); }, 300.0, 3);
  const double before_s = rig.duration_s();
  rig.law->lower(120.0, 121.0, 0.5);
  rig.law->lower(120.2, 120.8, 0.9);
  rig.law->plan();
  // At most 3 mm at half of the speed, and a change by 125 mm/s on both sides with at least a quarter of 3000 mm/s^2.
  EXPECT_GT(rig.duration_s(), before_s + 0.5 * 1.0 / 250.0);
  EXPECT_LT(rig.duration_s(), before_s + 3.0 / 125.0 + 2.0 * 0.5 * 125.0 / 750.0);
  for (std::size_t i = 0; i < rig.law->size(); ++i) {
    if (rig.law->s(i) < 120.0 || rig.law->s(i) > 121.0) continue;
    EXPECT_LE(rig.law->square(i), 125.0 * 125.0 * (1.0 + 1e-9));
  }
}

TEST(SpeedLaw, GoesOnFromItsSpeedWhenThePathIsContinued) {
  LawRig rig;
  rig.plan([](double) { return constant(250.0, 3'000.0); }, 100.0, 100);
  const std::size_t at_50 = [&] {
    std::size_t i = 0;
    while (rig.law->s(i) < 50.0) ++i;
    return i;
  }();
  const double there = rig.law->square(at_50);
  rig.law->drop_front(at_50);
  for (int i = 1; i <= 100; ++i) ASSERT_TRUE(rig.law->append(100.0 + i, constant(250.0, 3'000.0)));
  rig.law->plan();
  EXPECT_EQ(rig.law->square(0), there);
  EXPECT_NEAR(rig.duration_s(), 150.0 / 250.0 + 0.5 * 250.0 / 3'000.0, 1e-9);
}

TEST(SpeedLaw, UsesItsRingManyTimesOver) {
  LawRig rig;
  rig.law->clear();
  double s = 0.0;
  for (int round = 0; round < 40; ++round) {
    while (rig.law->size() < 1'000) ASSERT_TRUE(rig.law->append(s++, constant(250.0, 3'000.0)));
    rig.law->plan();
    rig.law->drop_front(500);
  }
  EXPECT_NEAR(rig.law->square(0), 250.0 * 250.0, 1e-6);
  EXPECT_EQ(rig.law->square(rig.law->size() - 1), 0.0);
}

TEST(SpeedLaw, RefusesAPointTooMany) {
  LawRig rig;
  for (std::size_t i = 0; i < SpeedLaw::kMaxPoints; ++i) ASSERT_TRUE(rig.law->append(1.0, constant(1.0, 1.0)));
  EXPECT_FALSE(rig.law->append(2.0, constant(1.0, 1.0)));
}

TEST(LawLimits, SlowedDownByAShareTakeThatMuchLonger) {
  LawRig rig;
  Random random{7};
  const RandomPath path{random};
  rig.plan(path, 6.0, 200);
  const double duration_s = rig.duration_s();
  rig.plan(
      [&](double s) {
        LawLimits limits = path(s);
        slow_down(limits, 0.8);
        return limits;
      },
      6.0, 200);
  EXPECT_NEAR(rig.duration_s(), duration_s / 0.8, 1e-6 * duration_s);
}

TEST(TimeTable, EndsMotionsBetweenStopsAtWholeTicks) {
  LawRig rig;
  rig.law->clear();
  for (const double s : {0.0, 10.0, 40.0}) {
    ASSERT_TRUE(rig.law->append(s, constant(250.0, 3'000.0), s == 10.0));
  }
  rig.law->plan();
  rig.table->assign(*rig.law);
  const Ticks first = whole_ticks(2.0 * std::sqrt(10.0 / 3'000.0));
  EXPECT_EQ(rig.table->duration(), first + whole_ticks(30.0 / 250.0 + 250.0 / 3'000.0));
  EXPECT_NEAR(rig.table->time_at(10.0), seconds(first), 1e-12);
  EXPECT_EQ(rig.table->position(seconds(first)), 10.0);
  EXPECT_EQ(rig.table->size(), 6u);  // each trapezoid or triangle is its corners
}

TEST(TimeTable, IsContinuousInPositionAndSpeedAndInvertsItself) {
  LawRig rig;
  Random random{8};
  rig.plan(RandomPath{random}, 6.0, 150);
  rig.table->assign(*rig.law);
  const TimeTable& table = *rig.table;
  double before = 0.0, step_before = 0.0;
  for (std::int64_t tick = 1; tick <= table.duration().value(); ++tick) {
    const double t_s = seconds(Ticks{tick});
    const double s = table.position(t_s);
    ASSERT_GE(s, before);
    ASSERT_NEAR(s - before, step_before, 30.0 * kTickSeconds * kTickSeconds);
    ASSERT_NEAR(table.time_at(s), t_s, 1e-9);
    step_before = s - before;
    before = s;
  }
  EXPECT_EQ(before, 6.0);
}

}  // namespace
}  // namespace armature
