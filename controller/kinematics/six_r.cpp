#include "controller/kinematics/six_r.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "controller/kinematics/turns.hpp"

namespace armature {

namespace {

constexpr double kRelativeTolerance = 1e-9;
// theta_4 has a rounding noise of 1e-16 / |sin theta_5|: at 1e-9 that is a hundredth of a motor pulse. The second
// difference of a path is more sensitive.
constexpr double kWristZone = 1e-9;

[[nodiscard]] std::uint8_t singular_mask(bool shoulder, std::uint8_t elbow, bool wrist) noexcept {
  return static_cast<std::uint8_t>((shoulder ? kShoulderSingular : 0) | elbow | (wrist ? kWristSingular : 0));
}

// The distance of the joints from the previous ones. Equal largest steps are ordered by the sum of squares.
struct Step {
  double largest = std::numeric_limits<double>::infinity();
  double squares = std::numeric_limits<double>::infinity();

  Step() noexcept = default;
  Step(const Theta& theta, const Theta& previous) noexcept : largest{0.0}, squares{0.0} {
    for (std::size_t i = 0; i < theta.size(); ++i) {
      const double step = std::fabs(theta[i] - previous[i]);
      largest = std::max(largest, step);
      squares += step * step;
    }
  }
  [[nodiscard]] bool shorter_than(const Step& other) const noexcept {
    return largest != other.largest ? largest < other.largest : squares < other.squares;
  }
};

}  // namespace

// Joint 1, and the vertical plane of the arm that follows from it.
struct SixR::Shoulder {
  double theta1;  // [-pi, pi]
  double s1, c1;
  bool singular;

  [[nodiscard]] Shoulder back() const noexcept { return {opposite(theta1), -s1, -c1, singular}; }
};

// Joints 2 and 3 of both elbows: index 0 is elbow +1, 1 is elbow -1.
struct SixR::Elbow {
  double theta2[2], theta3[2];  // [-pi, pi]
  double margin_mm = 0.0;       // > 0: unreachable; the angles stretch or fold the arm towards it
  std::uint8_t singular = 0;
  bool clamped = false;
};

// Joints 4 to 6 of flip +1, [-pi, pi]; other() is flip -1.
struct SixR::Wrist {
  double theta4, theta5, theta6;
  bool singular;

  [[nodiscard]] Wrist other() const noexcept { return {opposite(theta4), -theta5, opposite(theta6), singular}; }

  // From W = R03^T R = R36, eq. (31) and (32) with corrected signs. theta_4 must be in the equation of theta_6: only
  // then is the orientation correct for any chosen theta_4.
  static Wrist solve(const Shoulder& shoulder, double theta2, double theta3, const Eigen::Matrix3d& rotation,
                     double zone, double previous_theta4) noexcept {
    const auto [s23, c23] = math::sin_cos(theta2 + theta3);
    const Eigen::RowVector3d outward = shoulder.c1 * rotation.row(0) + shoulder.s1 * rotation.row(1);
    const Eigen::RowVector3d w1 = c23 * outward + s23 * rotation.row(2);
    const Eigen::RowVector3d w2 = shoulder.s1 * rotation.row(0) - shoulder.c1 * rotation.row(1);
    const double w33 = s23 * outward(2) - c23 * rotation(2, 2);
    const double sin5 = std::sqrt(w1(2) * w1(2) + w2(2) * w2(2));  // 1 - w33^2 would lose half the digits

    const auto theta6 = [&](double s4, double c4) {
      return math::atan2(c4 * w2(0) - s4 * w1(0), c4 * w2(1) - s4 * w1(1));
    };
    if (sin5 < zone) {
      const auto [s4, c4] = math::sin_cos(previous_theta4);
      return {wrapped(previous_theta4), math::atan2(c4 * w1(2) + s4 * w2(2), w33), theta6(s4, c4), true};
    }
    return {math::atan2(w2(2), w1(2)), math::atan2(sin5, w33), theta6(w2(2) / sin5, w1(2) / sin5), false};
  }
};

SixR::SixR(const ArmGeometry& geometry) noexcept
    : geometry_{geometry},
      forearm_mm_{math::hypot(geometry.a3_mm, geometry.d4_mm)},
      phi_rad_{math::atan2(geometry.d4_mm, geometry.a3_mm)},
      longest_mm_{geometry.a2_mm + forearm_mm_},
      shortest_mm_{std::fabs(geometry.a2_mm - forearm_mm_)},
      difference_mm2_{(geometry.a2_mm - forearm_mm_) * longest_mm_},
      tolerance_mm_{kRelativeTolerance * longest_mm_} {}

Eigen::Vector3d SixR::wrist_centre(const Transform& base_T_flange) const noexcept {
  return base_T_flange.position_mm - geometry_.d6_mm * base_T_flange.rotation.col(2);
}

// The front one (shoulder +1), eq. (39).
SixR::Shoulder SixR::shoulder(const Eigen::Vector3d& wrist, double previous_rad) const noexcept {
  const double radius = std::sqrt(wrist.x() * wrist.x() + wrist.y() * wrist.y());
  if (radius < tolerance_mm_) {
    const auto [s1, c1] = math::sin_cos(previous_rad);
    return {wrapped(previous_rad), s1, c1, true};
  }
  return {math::atan2(wrist.y(), wrist.x()), wrist.y() / radius, wrist.x() / radius, false};
}

// The triangle of upper arm a2, forearm k and distance to the wrist centre: eq. (40)-(42) with Heron's area instead of
// the cosine rule, which exceeds 1 by rounding at the reach limit.
SixR::Elbow SixR::elbow(const Eigen::Vector3d& wrist, const Shoulder& shoulder, double previous_rad) const noexcept {
  const double x = shoulder.c1 * wrist.x() + shoulder.s1 * wrist.y() - geometry_.a1_mm;
  const double y = wrist.z() - geometry_.d1_mm;
  const double distance2 = x * x + y * y;
  const double distance = std::sqrt(distance2);
  const double to_outer = longest_mm_ - distance, to_inner = distance - shortest_mm_;
  const double inside = std::min(to_outer, to_inner);

  Elbow result;
  if (inside < -tolerance_mm_) result.margin_mm = -inside;
  result.clamped = inside < 0.0;
  if (inside <= tolerance_mm_) result.singular = kElbowSingular;

  const double area2 = (to_outer * to_inner) * ((longest_mm_ + distance) * (distance + shortest_mm_));
  const double s = result.clamped ? 0.0 : std::sqrt(area2);  // 2 a2 k |sin(theta_3 - phi)|
  const double delta = math::atan2(s, distance2 - geometry_.a2_mm * geometry_.a2_mm - forearm_mm_ * forearm_mm_);
  result.theta3[0] = wrapped(phi_rad_ - delta);
  result.theta3[1] = wrapped(phi_rad_ + delta);
  if (distance < tolerance_mm_) {
    result.singular |= kFoldedSingular;
    result.theta2[0] = result.theta2[1] = wrapped(previous_rad);
  } else {
    const double gamma = math::atan2(y, x);
    const double beta = math::atan2(s, distance2 + difference_mm2_);
    result.theta2[0] = wrapped(gamma + beta);
    result.theta2[1] = wrapped(gamma - beta);
  }
  return result;
}

RawSolutions SixR::inverse(const Transform& base_T_flange, const Theta& previous) const noexcept {
  RawSolutions solutions;
  if (!is_rigid(base_T_flange) || !are_angles(previous)) {
    solutions.status = IkStatus::kInvalidInput;
    return solutions;
  }
  const Eigen::Vector3d centre = wrist_centre(base_T_flange);
  const Shoulder front = shoulder(centre, previous[0]);
  for (const int side : {+1, -1}) {
    const Shoulder here = side > 0 ? front : front.back();
    const Elbow arm = elbow(centre, here, previous[1]);
    if (arm.margin_mm > 0.0) {
      const bool first = solutions.margin_mm == 0.0;
      solutions.margin_mm = first ? arm.margin_mm : std::min(solutions.margin_mm, arm.margin_mm);
      continue;
    }
    for (const int bend : {+1, -1}) {
      const std::size_t i = bend > 0 ? 0 : 1;
      const Wrist wrist =
          Wrist::solve(here, arm.theta2[i], arm.theta3[i], base_T_flange.rotation, kWristZone, previous[3]);
      const auto add = [&](const Wrist& w, int flip) {
        RawBranch& branch = solutions.branches[solutions.count++];
        branch.theta = {here.theta1, arm.theta2[i], arm.theta3[i], w.theta4, w.theta5, w.theta6};
        branch.shoulder = static_cast<std::int8_t>(side);
        branch.elbow = static_cast<std::int8_t>(bend);
        branch.flip = static_cast<std::int8_t>(flip);
        branch.singular = singular_mask(here.singular, arm.singular, w.singular);
        branch.clamped = arm.clamped;
      };
      add(wrist, +1);
      if (!wrist.singular) add(wrist.other(), -1);
    }
  }
  if (solutions.count > 0) {
    solutions.status = IkStatus::kOk;
    solutions.margin_mm = 0.0;
  }
  return solutions;
}

RawTracking SixR::track(const Transform& base_T_flange, const Theta& previous, double wrist_zone) const noexcept {
  RawTracking result;
  if (!is_rigid(base_T_flange) || !are_angles(previous)) {
    result.status = IkStatus::kInvalidInput;
    return result;
  }
  const Eigen::Vector3d centre = wrist_centre(base_T_flange);
  Shoulder here = shoulder(centre, previous[0]);
  double theta1 = nearest_turn(here.theta1, previous[0]);
  if (std::fabs(theta1 - previous[0]) > 0.5 * std::numbers::pi) {
    here = here.back();
    theta1 = nearest_turn(here.theta1, previous[0]);
  }
  const Elbow arm = elbow(centre, here, previous[1]);
  double theta2[2], theta3[2], least[2];  // least: no wrist gives a smaller step of this elbow
  for (std::size_t i = 0; i < 2; ++i) {
    theta2[i] = nearest_turn(arm.theta2[i], previous[1]);
    theta3[i] = nearest_turn(arm.theta3[i], previous[2]);
    least[i] = std::max(std::fabs(theta2[i] - previous[1]), std::fabs(theta3[i] - previous[2]));
  }
  const std::size_t nearer = least[0] <= least[1] ? 0 : 1;
  Step best;
  for (const std::size_t i : {nearer, 1 - nearer}) {
    if (least[i] > best.largest) break;
    const Wrist wrist =
        Wrist::solve(here, arm.theta2[i], arm.theta3[i], base_T_flange.rotation, wrist_zone, previous[3]);
    const auto consider = [&](const Wrist& w) {
      const Theta theta{theta1,
                        theta2[i],
                        theta3[i],
                        nearest_turn(w.theta4, previous[3]),
                        nearest_turn(w.theta5, previous[4]),
                        nearest_turn(w.theta6, previous[5])};
      const Step step{theta, previous};
      if (step.shorter_than(best)) {
        best = step;
        result.theta = theta;
        result.singular = singular_mask(here.singular, arm.singular, w.singular);
      }
    };
    consider(wrist);
    if (!wrist.singular) consider(wrist.other());
  }
  result.found = true;
  result.margin_mm = arm.margin_mm;
  result.status = arm.margin_mm > 0.0 ? IkStatus::kUnreachable : status_of(result.singular, arm.clamped);
  return result;
}

}  // namespace armature
