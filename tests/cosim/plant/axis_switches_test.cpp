// Switches in counts, against the joint angles that a count shows.
#include "cosim/plant/axis_switches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

using armature::test::SplitMix;

constexpr std::uint64_t kSwitchesSeed = 11;

TEST(AxisSwitches, AreActiveAtTheCountsWhoseAngleIsInTheirRange) {
  SplitMix random{kSwitchesSeed};
  const auto angle = [&random] { return (static_cast<double>(random.below(400'001)) - 200'000.0) * 1e-3; };
  for (int i = 0; i < 400; ++i) {
    const double gear = random.below(2) == 0 ? 50.0 : -0.37 * static_cast<double>(1 + random.below(300));
    const double deg_per_count = 360.0 / (gear * 4.0 * static_cast<double>(1 + random.below(5000)));
    AxisSpec spec;
    const double home = angle(), limit = angle();
    spec.home_switch_deg = {{home, home + static_cast<double>(random.below(2001)) * 1e-3}};
    spec.limit_switch_deg = {{std::min(home, limit) - 10.0, std::max(home, limit) + 10.0}};
    const AxisSwitches switches{spec, deg_per_count};
    for (const double deg : {spec.home_switch_deg->front(), spec.home_switch_deg->back(),
                             spec.limit_switch_deg->front(), spec.limit_switch_deg->back()}) {
      const std::int64_t here = std::llround(deg / deg_per_count);
      for (std::int64_t count = here - 2; count <= here + 2; ++count) {
        SCOPED_TRACE(testing::Message() << "seed " << kSwitchesSeed << ", draw " << i << ", count " << count);
        const double shown = static_cast<double>(count) * deg_per_count;
        ASSERT_EQ(switches.home(Counts{count}),
                  shown >= spec.home_switch_deg->front() && shown <= spec.home_switch_deg->back());
        ASSERT_EQ(switches.limit_neg(Counts{count}), shown <= spec.limit_switch_deg->front());
        ASSERT_EQ(switches.limit_pos(Counts{count}), shown >= spec.limit_switch_deg->back());
      }
    }
  }
}

TEST(AxisSwitches, AreSteadyWhereNoneChanges) {
  AxisSpec spec;
  spec.home_switch_deg = {{-1.0, 1.0}};
  spec.limit_switch_deg = {{-10.0, 10.0}};
  const AxisSwitches switches{spec, 0.1};
  const auto level = [&](std::int64_t count) {
    return switches.home(Counts{count}) + 2 * switches.limit_neg(Counts{count}) + 4 * switches.limit_pos(Counts{count});
  };
  for (std::int64_t from = -110; from <= 110; ++from) {
    bool steady = true;
    for (std::int64_t to = from; to <= 110; ++to) {
      steady = steady && level(to) == level(from);
      ASSERT_EQ(switches.are_steady(Counts{from}, Counts{to}), steady) << from << " to " << to;
      ASSERT_EQ(switches.are_steady(Counts{to}, Counts{from}), steady) << to << " to " << from;
      ASSERT_EQ(switches.steady_around(Counts{from}).has(Counts{to}), steady) << to << " around " << from;
      ASSERT_EQ(switches.steady_around(Counts{to}).has(Counts{from}), steady) << from << " around " << to;
    }
  }
}

TEST(AxisSwitches, AreNeverActiveOnAnAxisThatHasNone) {
  const AxisSwitches switches{AxisSpec{}, 0.1};
  for (const std::int64_t count : {-1'000'000'000, 0, 1'000'000'000}) {
    EXPECT_FALSE(switches.home(Counts{count}) || switches.limit_neg(Counts{count}) ||
                 switches.limit_pos(Counts{count}));
  }
  EXPECT_TRUE(switches.are_steady(Counts{-1'000'000'000}, Counts{1'000'000'000}));
}

}  // namespace
}  // namespace armature::cosim
