#include "controller/kinematics/jacobian.hpp"

#include <Eigen/Geometry>

namespace armature {

Jacobian geometric_jacobian(const PerAxis<JointAxis>& axes, std::size_t joints,
                            const Eigen::Vector3d& flange_mm) noexcept {
  Jacobian jacobian = Jacobian::Zero();
  for (std::size_t joint = 0; joint < joints; ++joint) {
    const auto column = static_cast<Eigen::Index>(joint);
    jacobian.block<3, 1>(0, column) = axes[joint].direction.cross(flange_mm - axes[joint].origin_mm);
    jacobian.block<3, 1>(3, column) = axes[joint].direction;
  }
  return jacobian;
}

}  // namespace armature
