// How near exact set-points come to the limits of the joints, and the first that is beyond one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature::test {

struct JointEnvelope {
  double speed = 0, accel = 0, range = 0;  // of any axis, as shares of its limits; the range from its middle
  std::string beyond;                      // the first set-point beyond a limit, in words; empty: there is none

  void add(const JointEnvelope& other) {
    speed = std::max(speed, other.speed);
    accel = std::max(accel, other.accel);
    range = std::max(range, other.range);
    if (beyond.empty()) beyond = other.beyond;
  }
};

// `points`: of successive ticks. A stop may end behind the range by the rounding of one tick (joint_steps.cpp).
inline JointEnvelope joint_envelope(const RobotModel& robot, std::span<const PerAxis<Radians>> points) {
  using Real = long double;
  constexpr Real kTick = 50e-6L, kRounding = 2e-6L;
  JointEnvelope envelope;
  for (std::size_t i = 2; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
      const AxisModel& model = robot.axes[axis];
      const auto q = [&](std::size_t back) { return static_cast<Real>(points[i - back][axis].value()); };
      const Real tick_rad = model.max_accel_rad_s2 * kTick * kTick;
      const Real half = (static_cast<Real>(model.max_rad) - model.min_rad) / 2,
                 middle = (static_cast<Real>(model.max_rad) + model.min_rad) / 2;
      const JointEnvelope found{.speed = static_cast<double>(std::fabs(q(0) - q(1)) / kTick / model.max_speed_rad_s),
                                .accel = static_cast<double>(std::fabs(q(0) - 2 * q(1) + q(2)) / tick_rad),
                                .range = static_cast<double>(std::fabs(q(0) - middle) / half),
                                .beyond = {}};
      envelope.add(found);
      const bool inside = found.speed <= 1 + kRounding && found.accel <= 1 + kRounding &&
                          found.range <= 1 + (tick_rad + kRounding * kTick) / half;
      if (inside || !envelope.beyond.empty()) continue;
      envelope.beyond = "axis " + std::to_string(axis + 1) + " at set-point " + std::to_string(i) + ": speed " +
                        std::to_string(found.speed) + ", acceleration " + std::to_string(found.accel) + ", range " +
                        std::to_string(found.range);
    }
  }
  return envelope;
}

}  // namespace armature::test
