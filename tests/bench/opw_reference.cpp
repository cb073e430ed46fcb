#include "tests/bench/opw_reference.hpp"

#include <cmath>
#include <numbers>

namespace armature::bench {

OpwSolutions opw_inverse(const OpwLengths& arm, const Transform& base_T_flange) noexcept {
  constexpr double kPi = std::numbers::pi;
  const Eigen::Matrix3d& e = base_T_flange.rotation;
  const Eigen::Vector3d centre = base_T_flange.position_mm - arm.c4 * e.col(2);

  // Joints 1 to 3: shoulder in front and behind, with two elbows each.
  const double out = std::sqrt(centre.x() * centre.x() + centre.y() * centre.y() - arm.b * arm.b) - arm.a1;
  const double out_behind = out + 2.0 * arm.a1;
  const double up = centre.z() - arm.c1;
  const double heading = std::atan2(centre.y(), centre.x()), aside = std::atan2(arm.b, out + arm.a1);
  const double front2 = out * out + up * up, behind2 = out_behind * out_behind + up * up;
  const double upper2 = arm.c2 * arm.c2, fore2 = arm.a2 * arm.a2 + arm.c3 * arm.c3;
  const double fore = std::sqrt(fore2), bend = std::atan2(arm.a2, arm.c3);
  const double at2_front = std::acos((front2 + upper2 - fore2) / (2.0 * std::sqrt(front2) * arm.c2));
  const double at2_behind = std::acos((behind2 + upper2 - fore2) / (2.0 * std::sqrt(behind2) * arm.c2));
  const double at3_front = std::acos((front2 - upper2 - fore2) / (2.0 * arm.c2 * fore));
  const double at3_behind = std::acos((behind2 - upper2 - fore2) / (2.0 * arm.c2 * fore));
  const double lean = std::atan2(out, up), lean_behind = std::atan2(out_behind, up);
  const double theta1[2] = {heading - aside, heading + aside - kPi};
  const double theta2[4] = {lean - at2_front, lean + at2_front, -at2_behind - lean_behind, at2_behind - lean_behind};
  const double theta3[4] = {at3_front - bend, -at3_front - bend, at3_behind - bend, -at3_behind - bend};

  OpwSolutions solutions;
  for (std::size_t side = 0; side < 2; ++side) {
    const double s1 = std::sin(theta1[side]), c1 = std::cos(theta1[side]);
    const Eigen::RowVector3d outward = c1 * e.row(0) + s1 * e.row(1);
    for (std::size_t i = 2 * side; i < 2 * side + 2; ++i) {
      const double s23 = std::sin(theta2[i] + theta3[i]), c23 = std::cos(theta2[i] + theta3[i]);
      const double m = s23 * outward.z() + e(2, 2) * c23;
      const double theta4 = std::atan2(e(1, 2) * c1 - e(0, 2) * s1, c23 * outward.z() - e(2, 2) * s23);
      const double theta5 = std::atan2(std::sqrt(1.0 - m * m), m);
      const double theta6 = std::atan2(s23 * outward.y() + e(2, 1) * c23, -s23 * outward.x() - e(2, 0) * c23);
      solutions[i] = {theta1[side], theta2[i], theta3[i], theta4, theta5, theta6};
      solutions[i + 4] = {theta1[side], theta2[i], theta3[i], theta4 + kPi, -theta5, theta6 - kPi};
    }
  }
  return solutions;
}

}  // namespace armature::bench
