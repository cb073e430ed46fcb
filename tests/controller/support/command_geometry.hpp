// Geometry that tests of commands share.
#pragma once

#include <Eigen/Core>

#include "controller/trajectory/path/arm_plane.hpp"

namespace armature::test {

// A quarter turn about z, written out: x becomes y.
inline const Eigen::Matrix3d kQuarter = (Eigen::Matrix3d() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished();

inline const ArmPlane kSixAxes{{.family = ArmFamily::kSixR}, {}};

}  // namespace armature::test
