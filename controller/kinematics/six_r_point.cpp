#include <cmath>
#include <cstddef>

#include "controller/base/math.hpp"
#include "controller/kinematics/six_r.hpp"
#include "controller/kinematics/six_r_parts.hpp"
#include "controller/kinematics/turns.hpp"

namespace armature {

// Joints 4 to 6 hold the point at a constant place in the frame of the forearm. So the arm is one with a longer
// forearm, and with an offset from the plane of joints 2 and 3.
RawTracking SixR::track_point(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& flange_p_mm,
                              const Theta& previous) const noexcept {
  RawTracking result;
  if (!are_angles(previous) || !(point_mm.squaredNorm() <= kFarthest_mm * kFarthest_mm)) {
    result.status = IkStatus::kInvalidInput;
    return result;
  }
  const auto [s4, c4] = math::sin_cos(previous[3]);
  const auto [s5, c5] = math::sin_cos(previous[4]);
  const auto [s6, c6] = math::sin_cos(previous[5]);
  const Eigen::Vector3d p = flange_p_mm + Eigen::Vector3d{0.0, 0.0, geometry_.d6_mm};
  const Eigen::Vector3d bent{c6 * p.x() - s6 * p.y(), s6 * p.x() + c6 * p.y(), p.z()};
  const double along = c5 * bent.x() + s5 * bent.z();
  const Eigen::Vector3d in_forearm{c4 * along - s4 * bent.y(), s4 * along + c4 * bent.y(),
                                   c5 * bent.z() - s5 * bent.x()};
  ArmGeometry geometry = geometry_;
  geometry.a3_mm += in_forearm.x();
  geometry.d4_mm += in_forearm.z();
  const SixR longer{geometry};

  // (x, y) = r (c1, s1) + aside (s1, -c1)
  const double aside = in_forearm.y(), rho2 = point_mm.x() * point_mm.x() + point_mm.y() * point_mm.y();
  const double r2 = rho2 - aside * aside;
  if (!(r2 > tolerance_mm_ * tolerance_mm_)) {
    result.status = IkStatus::kUnreachable;
    result.margin_mm = std::fabs(aside) - std::sqrt(rho2);
    return result;
  }
  const auto theta1 = [&](double r) {
    return nearest_turn(math::atan2(r * point_mm.y() + aside * point_mm.x(), r * point_mm.x() - aside * point_mm.y()),
                        previous[0]);
  };
  const double front = theta1(std::sqrt(r2)), back = theta1(-std::sqrt(r2));
  const bool in_front = std::fabs(front - previous[0]) <= std::fabs(back - previous[0]);
  const double theta = in_front ? front : back, r = in_front ? std::sqrt(r2) : -std::sqrt(r2);
  const auto [s1, c1] = math::sin_cos(theta);
  const Triangle sides = longer.triangle({r * c1, r * s1, point_mm.z()}, Shoulder{theta, s1, c1, false});
  Arctangents turns;
  longer.add_elbow(turns, sides);
  turns.compute();
  const Elbow arm = longer.elbow(turns, 0, sides, previous[1]);
  JointStep best;
  for (std::size_t i = 0; i < 2; ++i) {
    const Theta found{theta,
                      nearest_turn(arm.theta2[i], previous[1]),
                      nearest_turn(arm.theta3[i], previous[2]),
                      previous[3],
                      previous[4],
                      previous[5]};
    const JointStep step{found, previous};
    if (!step.shorter_than(best)) continue;
    best = step;
    result.theta = found;
  }
  result.found = true;
  result.singular = sides.singular;
  result.margin_mm = sides.margin_mm;
  result.status = sides.margin_mm > 0.0 ? IkStatus::kUnreachable : status_of(result.singular, sides.clamped);
  return result;
}

}  // namespace armature
