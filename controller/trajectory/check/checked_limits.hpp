// The limits of an axis against which the set-points of a plan are checked.
#pragma once

#include <limits>

#include "controller/robot/axis_units.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

struct CheckedLimits {
  static constexpr double kShare = 0.98;  // of the limits of the axis; path_check.hpp says why

  double speed_rad_s, accel_rad_s2;
  double jerk_rad_s3;  // infinite: the axis has none
  explicit CheckedLimits(const AxisModel& axis) noexcept
      : speed_rad_s{kShare * AxisUnits{axis}.max_speed_rad_s()},
        accel_rad_s2{kShare * axis.max_accel_rad_s2},
        jerk_rad_s3{axis.max_jerk_rad_s3 > 0.0 ? kShare * axis.max_jerk_rad_s3
                                               : std::numeric_limits<double>::infinity()} {}
};

}  // namespace armature
