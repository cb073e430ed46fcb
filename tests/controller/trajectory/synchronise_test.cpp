#include "controller/trajectory/profile/synchronise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/profile_checks.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/reference_data.hpp"

namespace armature {
namespace {

constexpr std::pair<const char*, SyncRule> kRules[] = {
    {"fig9", SyncRule::kFig9}, {"const_acc", SyncRule::kConstAcc}, {"time_scale", SyncRule::kTimeScale}};

struct AxesCase {
  PerAxis<double> distance{};
  PerAxis<ProfileLimits> limits{};
};

AxesCase read_case(const nlohmann::json& entry) {
  AxesCase result;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    result.distance[axis] = entry["q"][axis];
    result.limits[axis] = {.speed = entry["w"][axis], .accel = entry["a"][axis]};
  }
  return result;
}

TEST(Synchronise, AgreesWithTheReferenceUnderEveryRule) {
  const auto reference = test::read_reference("profiles.json");
  ASSERT_EQ(reference["synchronised"].size(), 18u);
  for (const auto& entry : reference["synchronised"]) {
    const AxesCase input = read_case(entry);
    for (const auto& [name, rule] : kRules) {
      const SynchronisedProfiles result = synchronise(input.distance, input.limits, rule);
      EXPECT_EQ(result.duration.value(), entry["N50us"].get<std::int64_t>());
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        SCOPED_TRACE(entry["kind"].get<std::string>() + " " + name + " axis " + std::to_string(axis + 1));
        const auto& expected = entry["rules"][name][axis];
        test::expect_profile(result.axes[axis], expected["profile"], 1e-12);
        test::expect_samples(result.axes[axis], expected["samples"], 1e-12);
      }
    }
  }
}

TEST(Synchronise, Figure9TakesExactly17400TicksWithTwoTrianglesOf40DegreesPerSecond) {
  const PerAxis<double> distance{80.4, -60.0, 50.0, 17.4, -17.4, 70.0};
  PerAxis<ProfileLimits> limits;
  limits.fill({.speed = 120.0, .accel = 600.0});
  limits[5].accel = 660.0;
  const SynchronisedProfiles result = synchronise(distance, limits, SyncRule::kFig9);
  EXPECT_EQ(result.duration, Ticks{17'400});
  const PerAxis<double> peak{120.0, 81.776676, 65.754001, 40.0, 40.0, 96.767633};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const bool triangle = axis == 3 || axis == 4;
    EXPECT_EQ(result.axes[axis].shape, triangle ? ProfileShape::kTriangle : ProfileShape::kTrapezoid);
    EXPECT_NEAR(result.axes[axis].peak_speed, peak[axis], 1e-6);
    EXPECT_NEAR(result.axes[axis].accel, triangle ? 91.954023 : limits[axis].accel, 1e-6);
  }
}

TEST(Synchronise, TheDurationIsTheNextWholeTick) {
  EXPECT_EQ(whole_ticks(0.0), Ticks{0});
  EXPECT_EQ(whole_ticks(1e-300), Ticks{1});
  EXPECT_EQ(whole_ticks(50e-6), Ticks{1});
  EXPECT_EQ(whole_ticks(50.0001e-6), Ticks{2});
  EXPECT_EQ(whole_ticks(120.0 / 600.0 + 80.4 / 120.0), Ticks{17'400});
  // Meant to be whole, but the sum in double is above: the naive ceiling adds a tick in some of these.
  for (int n = 1; n < 100'000; n += 7) ASSERT_EQ(whole_ticks(0.1 * kTickSeconds + (n - 0.1) * kTickSeconds), Ticks{n});
}

TEST(Synchronise, ADurationBeyondTicksSaturates) {
  constexpr Ticks kMax{std::numeric_limits<std::int64_t>::max()};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double longest_s : {0x1p63 * kTickSeconds, 1e15, 1e300, kInfinity, std::nan("")}) {
    EXPECT_EQ(whole_ticks(longest_s), kMax) << longest_s;
  }
  EXPECT_LT(whole_ticks(0x1p62 * kTickSeconds), kMax);
}

class SynchroniseProperties : public testing::TestWithParam<SyncRule> {};

// Random sets with distances from a ten-millionth of a degree to a turn, some of them 0.
AxesCase random_axes_case(test::Random& random) {
  AxesCase result;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    double q = random.real(-360.0, 360.0);
    for (auto scale = random.integer(0, 9); scale > 0; --scale) q *= 0.1;
    result.distance[axis] = random.integer(0, 9) == 0 ? 0.0 : q;
    result.limits[axis] = {.speed = random.real(5.0, 400.0), .accel = random.real(50.0, 5000.0)};
  }
  return result;
}

TEST_P(SynchroniseProperties, NoLimitIsExceededAndAllAxesEndTogetherOnTarget) {
  constexpr std::uint64_t kSeed = 20210907;
  test::Random random{kSeed};
  for (int draw = 0; draw < 20'000; ++draw) {
    const AxesCase input = random_axes_case(random);
    const SynchronisedProfiles result = synchronise(input.distance, input.limits, GetParam());
    const double duration_s = static_cast<double>(result.duration.value()) * kTickSeconds;
    // A duration may be rounded down by a millionth of a tick.
    const double slack = 1.0 + 1e-14 + 4e-6 / static_cast<double>(std::max<std::int64_t>(1, result.duration.value()));
    bool slowest_found = result.duration == Ticks{0};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const TrapezoidProfile& profile = result.axes[axis];
      const double q = std::fabs(input.distance[axis]);
      ASSERT_EQ(profile.duration_s, duration_s) << "seed " << kSeed << " draw " << draw << " axis " << axis + 1;
      ASSERT_EQ(position(profile, duration_s), input.distance[axis]);
      ASSERT_LE(profile.peak_speed, input.limits[axis].speed * slack) << "seed " << kSeed << " draw " << draw;
      ASSERT_LE(profile.accel, input.limits[axis].accel * slack) << "seed " << kSeed << " draw " << draw;
      ASSERT_GE(profile.cruise_s, -1e-12 * duration_s);
      // The area under the velocity is the distance.
      ASSERT_NEAR(profile.peak_speed * (profile.accel_s + profile.cruise_s), q, 1e-12 * q);
      // Discriminant of eq. (13): never negative, so eq. (14) is no exception but a rule.
      ASSERT_GE(duration_s * duration_s * slack * slack, 4.0 * q / input.limits[axis].accel);
      const double nominal_s = plan_profile(q, input.limits[axis]).duration_s;
      if (nominal_s > duration_s - kTickSeconds) slowest_found = true;
    }
    ASSERT_TRUE(slowest_found) << "longer than any axis needs, seed " << kSeed << " draw " << draw;
  }
}

// Down to the smallest number there is: long enough for every axis, or as long as can be said.
TEST_P(SynchroniseProperties, TheSlowerTheLongerWhateverTheSpeed) {
  constexpr std::uint64_t kSeed = 42;
  test::Random random{kSeed};
  for (int draw = 0; draw < 50; ++draw) {
    AxesCase input = random_axes_case(random);
    input.distance[0] = 1.0;
    Ticks faster{0};
    for (int power = 0; power < 1'080; ++power) {
      const SynchronisedProfiles result = synchronise(input.distance, input.limits, GetParam());
      ASSERT_GE(result.duration, faster) << "seed " << kSeed << " draw " << draw << " speed * 2^-" << power;
      faster = result.duration;
      if (result.duration.value() < std::numeric_limits<std::int64_t>::max()) {
        const double duration_s = static_cast<double>(result.duration.value()) * kTickSeconds;
        ASSERT_GE(duration_s * (1.0 + 1e-9), 1.0 / input.limits[0].speed) << "seed " << kSeed << " draw " << draw;
      }
      for (ProfileLimits& limits : input.limits) limits.speed *= 0.5;
    }
    ASSERT_EQ(faster.value(), std::numeric_limits<std::int64_t>::max());
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, SynchroniseProperties,
                         testing::Values(SyncRule::kFig9, SyncRule::kConstAcc, SyncRule::kTimeScale),
                         [](const auto& rule) { return std::string{kRules[static_cast<int>(rule.param)].first}; });

}  // namespace
}  // namespace armature
