// The largest speed at the near end of an interval, against halving; and the points that a law adds to its intervals.
#include "controller/trajectory/law/law_interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "controller/trajectory/law/speed_law.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::Random;

double spread(Random& random, double from, double to) {
  return std::exp(random.real(std::log(from), std::log(to)));
}

LawLimits random_limits(Random& random) {
  LawLimits limits;
  for (LawLimits::Band& band : limits.bands) {
    if (random.integer(0, 1) == 0) continue;
    band.by_accel = spread(random, 1e-6, 1e-2);
    band.by_square = spread(random, 1e-9, 1e-1);
  }
  for (LawLimits::Ellipse& ellipse : limits.ellipses) {
    const double by_accel = spread(random, 1e-6, 1e-2), by_square = spread(random, 1e-9, 1e-1);
    ellipse.accel2 = by_accel * by_accel;
    ellipse.square2 = by_square * by_square;
    ellipse.mixed = random.real(0.0, 0.9) * by_accel * by_square;
  }
  limits.most_square = spread(random, 1.0, 1e6);
  return limits;
}

// Whether a motion from `square` reaches 0..far_square within the limits.
bool reaches(const LawInterval& interval, double step, double square, double far_square) {
  const LawInterval::Accelerations a = interval.accelerations(square);
  return a.low <= a.high && square + 2.0 * step * a.low <= far_square && square + 2.0 * step * a.high >= 0.0;
}

// Up to the rounding of the largest square, that is: those near a stop are a billionth of it.
TEST(LawInterval, FindsTheLargestSpeedUpToRounding) {
  constexpr std::uint64_t kSeed = 91;
  SCOPED_TRACE(kSeed);
  Random random{kSeed};
  int roots = 0, small = 0;
  for (int draw = 0; draw < 20'000; ++draw) {
    const LawLimits near = random_limits(random), far = random_limits(random);
    const double step = spread(random, 1e-9, 1.0), far_most = spread(random, 1e-9, 1.0) * largest_square(far);
    const double far_square = random.integer(0, 3) == 0 ? 0.0 : far_most;
    const LawInterval interval{near, far, step};
    const double found = interval.largest_near(far_square);
    double low = 0.0, high = largest_square(near);
    while (high - low > 1e-14 * high) {
      const double middle = 0.5 * (low + high);
      if (!(middle > low && middle < high)) break;
      (reaches(interval, step, middle, far_square) ? low : high) = middle;
    }
    ASSERT_NEAR(found, low, 1e-12 * low + 1e-15 * largest_square(near)) << draw;
    const bool limited = low < (1.0 - 1e-9) * largest_square(near);
    roots += limited ? 1 : 0;
    small += limited && low < 1e-9 * largest_square(near) ? 1 : 0;
  }
  EXPECT_GT(roots, 15'000);
  EXPECT_GT(small, 300);
}

LawLimits with_square(double square, double accel) {
  LawLimits limits;
  limits.bands[0] = {.by_accel = 1.0 / accel};
  limits.most_square = square;
  return limits;
}

// A motion that is fast between three slow points changes its acceleration at four places between them.
TEST(SpeedLawPoints, AreAddedOnlyWhereTheAccelerationChanges) {
  constexpr std::uint64_t kSeed = 92;
  SCOPED_TRACE(kSeed);
  Random random{kSeed};
  const auto law = std::make_unique<SpeedLaw>();
  for (int draw = 0; draw < 200; ++draw) {
    const double square = random.real(1e4, 25e4), accel = random.real(100.0, 10'000.0), ramp = square / accel;
    const LawLimits fast = with_square(square, accel);
    double s = 0.0;
    law->clear();
    ASSERT_TRUE(law->append(s, fast));
    for (int i = 0; i < 2; ++i) {
      s += ramp * random.real(0.5, 3.0);
      ASSERT_TRUE(law->append(s, with_square(square * random.real(0.02, 0.5), accel)));
      ASSERT_TRUE(law->append(s, fast));
    }
    ASSERT_TRUE(law->append(s + ramp * random.real(0.5, 3.0), fast));
    law->plan();
    std::size_t close = 0;
    for (std::size_t i = 0; i + 1 < law->size(); ++i) {
      const double step = law->s(i + 1) - law->s(i);
      close += step > 0.0 && step < 1e-3 * ramp ? 1 : 0;
    }
    EXPECT_EQ(close, 0u) << draw;
  }
}

}  // namespace
}  // namespace armature
