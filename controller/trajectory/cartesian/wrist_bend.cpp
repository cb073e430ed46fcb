#include "controller/trajectory/cartesian/wrist_bend.hpp"

namespace armature {

std::array<double, 6> bend_between(const BendEnd& first, const BendEnd& last, double length) noexcept {
  const double v0 = first.slope * length, v1 = last.slope * length;
  const double a0 = first.bend * length * length, a1 = last.bend * length * length;
  const double change = last.angle - first.angle;
  return {first.angle,
          v0,
          0.5 * a0,
          10.0 * change - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1,
          -15.0 * change + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1,
          6.0 * change - 3.0 * (v0 + v1) - 0.5 * a0 + 0.5 * a1};
}

const WristBend* WristBends::at(double s) const noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    if (s > bends[i].from && s < bends[i].to) return &bends[i];
  }
  return nullptr;
}

IkTracking track_on_bend(const WristBend& bend, const Arm& arm, double s, const Eigen::Vector3d& tool_point_mm,
                         const Eigen::Vector3d& flange_p_tool_mm, const JointAngles& previous) noexcept {
  const double u = (s - bend.from) / (bend.to - bend.from);
  JointAngles near = previous;
  for (std::size_t i = 0; i < WristBend::kJoints; ++i) {
    const std::array<double, 6>& c = bend.coefficients[i];
    near[WristBend::kFirst + i] = Radians{c[0] + u * (c[1] + u * (c[2] + u * (c[3] + u * (c[4] + u * c[5]))))};
  }
  return arm.track_point(tool_point_mm, flange_p_tool_mm, near);
}

}  // namespace armature
