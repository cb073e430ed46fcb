// The limits of a commanded velocity of the tool.
#pragma once

#include "controller/base/members.hpp"

namespace armature {

struct ToolVelocityLimits {
  double accel_mm_s2 = 1'000.0;     // > 0
  double turn_accel_rad_s2 = 10.0;  // > 0
  double jerk_mm_s3 = 0.0;          // of changes of the commanded velocity; 0: not limited
  double turn_jerk_rad_s3 = 0.0;
  ARMATURE_MEMBERS(ToolVelocityLimits, accel_mm_s2, turn_accel_rad_s2, jerk_mm_s3, turn_jerk_rad_s3)
};

}  // namespace armature
