// All branches of an arm with an ortho-parallel basis and a spherical wrist, as a straight program of the equations of
// Brandstoetter, Angerer and Hofbaur (Austrian Robotics Workshop 2014), the ones that the library opw_kinematics uses:
// what the closed forms of the controller are compared with.
#pragma once

#include <array>
#include <cstddef>

#include "controller/kinematics/transform.hpp"

namespace armature::bench {

// The lengths of the paper [mm].
struct OpwLengths {
  double a1, a2, b, c1, c2, c3, c4;
};

// theta_1 .. theta_6 of the paper [rad], not wrapped. A solution that does not exist contains NaNs.
using OpwSolutions = std::array<std::array<double, 6>, 8>;

[[nodiscard]] OpwSolutions opw_inverse(const OpwLengths& arm, const Transform& base_T_flange) noexcept;

}  // namespace armature::bench
