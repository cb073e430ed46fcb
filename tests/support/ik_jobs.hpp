// Jobs of ik_cordic from arms and poses, and its angles.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "controller/kinematics/fixed/fixed_point.hpp"
#include "controller/kinematics/raw_solutions.hpp"
#include "cosim/model/ik_cordic/ik_solver.hpp"

namespace armature::test {

namespace ik = cosim::model::ik;

inline constexpr std::int32_t kOne = 1 << kEntryBits, kUnit = 1 << kLengthBits, kQuarterTurn = 1 << 30;

// Links of 9 and 11 units. The hand points along x, its x axis downwards.
inline ik::Job six_r_job() {
  ik::Job job;
  job.rotation = {0, 0, -kOne, 0, kOne, 0, kOne, 0, 0};
  job.upper = 9 * kUnit;
  job.fore = 11 * kUnit;
  job.phi = kQuarterTurn;
  job.previous1 = 1'000'000;
  job.previous2 = 2'000'000;
  job.previous4 = 4'000'000;
  return job;
}

// A pulse of a motor with 10 000 pulses per revolution and a gear of 50:1.
inline constexpr double kPulse_rad = 2.0 * std::numbers::pi / 500'000.0;

inline ik::Job job_of(const FixedArm& arm, const FixedPose& pose, const Theta& previous = {}) {
  return {.five_r = arm.five_r,
          .rotation = pose.rotation,
          .position = pose.position,
          .a1 = arm.a1,
          .base = arm.d1,
          .upper = static_cast<std::uint32_t>(arm.a2),
          .fore = static_cast<std::uint32_t>(arm.forearm),
          .a4 = arm.a4,
          .hand = arm.hand,
          .phi = arm.phi,
          .previous1 = binary_angle(previous[0]),
          .previous2 = binary_angle(previous[1]),
          .previous4 = binary_angle(previous[3])};
}

inline ik::Job job_of(const ArmGeometry& arm, const Transform& base_T_flange, const Theta& previous = {}) {
  const FixedArm fixed = fixed_arm(arm).value();
  return job_of(fixed, fixed_pose(base_T_flange, fixed).value(), previous);
}

// The index of a branch with these flags of IkBranch.
inline std::size_t branch_index(int shoulder, int elbow, int flip) {
  return (shoulder < 0 ? 4u : 0u) + (elbow < 0 ? 2u : 0u) + (flip < 0 ? 1u : 0u);
}

inline Theta theta_of(const ik::Solved& solved, std::size_t branch) {
  Theta theta{};
  for (std::size_t joint = 0; joint < theta.size(); ++joint) theta[joint] = radians_of(solved.theta[branch][joint]);
  return theta;
}

inline double pulses_between(double a_rad, double b_rad) {
  return std::fabs(std::remainder(a_rad - b_rad, 2.0 * std::numbers::pi)) / kPulse_rad;
}

}  // namespace armature::test
