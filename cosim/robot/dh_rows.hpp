// The Denavit-Hartenberg rows of an arm: A_i = Rz(theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i). The tables of the papers are
// named in controller/robot/arm_geometry.hpp.
#pragma once

#include <vector>

#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

struct DhRow {
  int alpha_quarters = 0;  // alpha in quarter turns: -1, 0 or 1
  double a_mm = 0, d_mm = 0;
};

// One row for each joint.
[[nodiscard]] inline std::vector<DhRow> dh_rows(const KinematicsSpec& arm) {
  if (arm.family == kFiveRFamily) {
    return {{-1, arm.a1_mm, 0}, {0, arm.a2_mm, 0}, {0, arm.a3_mm, 0}, {-1, arm.a4_mm, 0}, {0, 0, arm.d5_mm}};
  }
  return {{1, arm.a1_mm, arm.d1_mm}, {0, arm.a2_mm, 0}, {1, arm.a3_mm, 0},
          {-1, 0, arm.d4_mm},        {1, 0, 0},         {0, 0, arm.d6_mm}};
}

}  // namespace armature::cosim
