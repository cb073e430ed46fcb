// Comparison of profiles with tests/reference/profiles.json.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "controller/trajectory/profile/trapezoid.hpp"

namespace armature::test {

inline ProfileShape shape_of(const std::string& name) {
  if (name == "triangle") return ProfileShape::kTriangle;
  if (name == "trapezoid") return ProfileShape::kTrapezoid;
  EXPECT_EQ(name, "none");
  return ProfileShape::kNone;
}

// A difference of square roots loses digits near q a = w^2: cruise time and all times carry `tolerance` of the
// duration.
inline void expect_profile(const TrapezoidProfile& profile, const nlohmann::json& expected, double tolerance = 1e-13) {
  const double duration_s = expected["T"];
  ASSERT_EQ(profile.shape, shape_of(expected["shape"]));
  EXPECT_NEAR(profile.duration_s, duration_s, tolerance * duration_s);
  if (profile.shape == ProfileShape::kNone) return;
  EXPECT_EQ(profile.sign, expected["s"].get<double>());
  EXPECT_EQ(profile.distance, expected["q"].get<double>());
  EXPECT_NEAR(profile.peak_speed, expected["w"], tolerance * expected["w"].get<double>());
  EXPECT_NEAR(profile.accel, expected["a"], tolerance * expected["a"].get<double>());
  EXPECT_NEAR(profile.accel_s, expected["tc"], tolerance * duration_s);
  EXPECT_NEAR(profile.cruise_s, expected["tv"], tolerance * duration_s);
}

inline void expect_samples(const TrapezoidProfile& profile, const nlohmann::json& samples, double tolerance = 1e-13) {
  for (const auto& sample : samples) {
    const double t_s = sample[0];
    EXPECT_NEAR(position(profile, t_s), sample[1], tolerance * profile.distance) << "t=" << t_s;
    // The end may be one rounding of the time away.
    const double rounding = 4e-16 * profile.duration_s * profile.accel;
    EXPECT_NEAR(velocity(profile, t_s), sample[2], tolerance * profile.peak_speed + rounding) << "t=" << t_s;
    double to_jump = std::fmin(std::fabs(t_s - profile.accel_s), std::fabs(t_s - profile.duration_s));
    to_jump = std::fmin(to_jump, std::fabs(t_s - (profile.duration_s - profile.accel_s)));
    if (to_jump <= 1e-12 * profile.duration_s) continue;
    EXPECT_NEAR(acceleration(profile, t_s), sample[3], tolerance * profile.accel) << "t=" << t_s;
  }
}

}  // namespace armature::test
