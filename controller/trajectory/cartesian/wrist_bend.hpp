// Passages of the wrist singularity on which the orientation of the tool leaves its path, and the joints along a path
// with such passages.
//
// Near the singularity joints 4 and 6 would have to turn by up to half a turn within a short piece of the path. On a
// bend, joints 4 to 6 are interpolated between both of its ends, with continuous second derivatives. Joints 1 to 3 hold
// the tool point on the path exactly. Only the orientation differs, by about the angle by which the path misses the
// singularity. bend_layout.hpp places the bends.
#pragma once

#include <array>
#include <cstddef>

#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/transform.hpp"

namespace armature {

struct WristBend {
  static constexpr std::size_t kJoints = 3;                   // joints 4 to 6
  static constexpr std::size_t kFirst = kAxes - kJoints;      // index of joint 4
  double from = 0.0, to = 0.0;                                // parameter of the path
  std::array<std::array<double, 6>, kJoints> coefficients{};  // of u^0 .. u^5, u = 0 at `from` .. 1 at `to`; rad
};

// Values and derivatives by the parameter, of one joint at one end of a bend.
struct BendEnd {
  double angle = 0.0, slope = 0.0, bend = 0.0;
};
// The polynomial of one joint between two ends at a distance of `length`.
[[nodiscard]] std::array<double, 6> bend_between(const BendEnd& first, const BendEnd& last, double length) noexcept;

// The bends of a plan, in the order of the path. They do not overlap.
struct WristBends {
  static constexpr std::size_t kMax = 8;
  std::array<WristBend, kMax> bends{};
  std::size_t count = 0;

  // The bend at a parameter; null: none.
  [[nodiscard]] const WristBend* at(double s) const noexcept;
};

// The arm on a bend: joints 4 to 6 of the bend, joints 1 to 3 those nearest to `previous` that bring the tool to
// `tool_point_mm`. `flange_p_tool_mm`: the tool point in the frame of the flange.
[[nodiscard]] IkTracking track_on_bend(const WristBend& bend, const Arm& arm, double s,
                                       const Eigen::Vector3d& tool_point_mm, const Eigen::Vector3d& flange_p_tool_mm,
                                       const JointAngles& previous) noexcept;

}  // namespace armature
