// The geometric Jacobian of an arm with revolute joints.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "controller/base/axes.hpp"

namespace armature {

// Flange velocity = Jacobian * joint rates. Rows: v [mm/rad] then w [rad/rad], in the base frame; one column for each
// joint. Columns beyond the arm's joints are 0.
using Jacobian = Eigen::Matrix<double, 6, 6>;

// The axis of rotation of a joint: z_{i-1} and o_{i-1} of the Denavit-Hartenberg model, in the base frame.
struct JointAxis {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit vector, right-handed with a growing theta
  Eigen::Vector3d origin_mm = Eigen::Vector3d::Zero();   // any point of the line
};

// Columns (z x (flange - o), z) of the first `joints` axes; 0 <= joints <= 6.
[[nodiscard]] Jacobian geometric_jacobian(const PerAxis<JointAxis>& axes, std::size_t joints,
                                          const Eigen::Vector3d& flange_mm) noexcept;

}  // namespace armature
