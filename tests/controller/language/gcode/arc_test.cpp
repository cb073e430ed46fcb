// The geometry of arcs against arcs that are drawn from their centre.
#include "controller/language/gcode/canon/arc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

#include "tests/controller/support/random.hpp"

namespace armature::gcode {
namespace {

constexpr double kTolerance_mm = 1e-4;
constexpr double kPi = std::numbers::pi;

PlanePoint on_circle(PlanePoint centre, double radius, double angle) {
  return {.first = centre.first + radius * std::cos(angle), .second = centre.second + radius * std::sin(angle)};
}

// In both directions, short arcs and, with a negative radius, long ones.
TEST(Arc, HasTheCentreOfTheCircleItWasDrawnOn) {
  constexpr std::uint64_t kSeed = 1508;
  test::Random random{kSeed};
  for (int draw = 0; draw < 20'000; ++draw) {
    const double x = random.real(-500, 500), y = random.real(-500, 500), radius = random.real(0.1, 800);
    const double from = random.real(-kPi, kPi), sweep = random.real(0.01, 2 * kPi - 0.01);
    const bool clockwise = random.real(0, 1) < 0.5;
    if (std::fabs(sweep - kPi) < 0.01) continue;  // the centre depends on the last bits of the chord
    const PlanePoint centre{.first = x, .second = y};
    const PlanePoint start = on_circle(centre, radius, from);
    const PlanePoint end = on_circle(centre, radius, clockwise ? from - sweep : from + sweep);
    const ArcCentre found = centre_from_radius(start, end, sweep > kPi ? -radius : radius, clockwise, kTolerance_mm);
    ASSERT_TRUE(std::holds_alternative<PlanePoint>(found)) << "seed " << kSeed << ", draw " << draw;
    const PlanePoint got = std::get<PlanePoint>(found);
    EXPECT_NEAR(got.first, x, 1e-6) << "seed " << kSeed << ", draw " << draw;
    EXPECT_NEAR(got.second, y, 1e-6) << "seed " << kSeed << ", draw " << draw;
    EXPECT_NEAR(arc_angle(start, end, got, clockwise, 1), sweep, 1e-6) << "seed " << kSeed << ", draw " << draw;
  }
}

// The distances of start and end from the centre may differ by the tolerance, or by a thousandth of the larger one, but
// never by more than a hundred tolerances.
TEST(Arc, MayHaveAnEndThatIsALittleOffItsCircle) {
  const auto check = [](double radius, double off) {
    return check_centre({.first = radius, .second = 0.0}, {.first = 0.0, .second = radius + off}, {}, kTolerance_mm);
  };
  EXPECT_EQ(check(0.05, 0.9 * kTolerance_mm), std::nullopt);
  EXPECT_EQ(check(0.05, 1.1 * kTolerance_mm), ErrorCode::kArcRadiiDiffer);
  EXPECT_EQ(check(1.0, 0.00099), std::nullopt);
  EXPECT_EQ(check(1.0, 0.00101), ErrorCode::kArcRadiiDiffer);
  EXPECT_EQ(check(1.0, -0.00101), ErrorCode::kArcRadiiDiffer);
  EXPECT_EQ(check(100.0, 99.0 * kTolerance_mm), std::nullopt);
  EXPECT_EQ(check(100.0, 101.0 * kTolerance_mm), ErrorCode::kArcRadiiDiffer);
  EXPECT_EQ(check(0.9 * kTolerance_mm, 0.0), ErrorCode::kArcZeroRadius);
}

}  // namespace
}  // namespace armature::gcode
