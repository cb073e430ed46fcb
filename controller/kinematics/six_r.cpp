#include "controller/kinematics/six_r.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "controller/kinematics/six_r_parts.hpp"
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

}  // namespace

// Joints 4 to 6 of flip +1, [-pi, pi]; other() is flip -1.
struct SixR::Wrist {
  double theta4, theta5, theta6;
  bool singular;

  [[nodiscard]] Wrist other() const noexcept { return {opposite(theta4), -theta5, opposite(theta6), singular}; }

  // Adds the arctangents of the wrist: W = R03^T R = R36, eq. (31) and (32) with corrected signs. theta_4 must be in
  // the equation of theta_6: only then is the orientation correct for any chosen theta_4. Returns whether it is
  // singular.
  static bool add_to(Arctangents& turns, const Hand& hand, const math::SinCos& theta23, double zone,
                     double previous_theta4) noexcept {
    const auto [s23, c23] = theta23;
    const Eigen::RowVector3d w1 = c23 * hand.outward + s23 * hand.upward;
    const Eigen::RowVector3d& w2 = hand.across;
    const double w33 = s23 * hand.outward(2) - c23 * hand.upward(2);
    const double sin5 = std::sqrt(w1(2) * w1(2) + w2(2) * w2(2));  // 1 - w33^2 would lose half the digits

    const bool singular = sin5 < zone;
    const auto [s4, c4] =
        singular ? math::sin_cos(previous_theta4) : math::SinCos{.sin = w2(2) / sin5, .cos = w1(2) / sin5};
    turns.add(w2(2), w1(2));
    turns.add(singular ? c4 * w1(2) + s4 * w2(2) : sin5, w33);
    turns.add(c4 * w2(0) - s4 * w1(0), c4 * w2(1) - s4 * w1(1));
    return singular;
  }

  // After the arctangents are computed; `first` is the index of its first one.
  static Wrist from(const Arctangents& turns, std::size_t first, bool singular, double previous_theta4) noexcept {
    return {singular ? wrapped(previous_theta4) : turns[first], turns[first + 1], turns[first + 2], singular};
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

// Eq. (40)-(42) with Heron's area instead of the cosine rule, which exceeds 1 by rounding at the reach limit.
SixR::Triangle SixR::triangle(const Eigen::Vector3d& wrist, const Shoulder& shoulder) const noexcept {
  Triangle result;
  result.x = shoulder.c1 * wrist.x() + shoulder.s1 * wrist.y() - geometry_.a1_mm;
  result.y = wrist.z() - geometry_.d1_mm;
  result.distance2 = result.x * result.x + result.y * result.y;
  const double distance = std::sqrt(result.distance2);
  const double to_outer = longest_mm_ - distance, to_inner = distance - shortest_mm_;
  const double inside = std::min(to_outer, to_inner);
  if (inside < -tolerance_mm_) result.margin_mm = -inside;
  result.clamped = inside < 0.0;
  if (inside <= tolerance_mm_) result.singular = kElbowSingular;
  if (distance < tolerance_mm_) result.singular |= kFoldedSingular;
  const double area2 = (to_outer * to_inner) * ((longest_mm_ + distance) * (distance + shortest_mm_));
  result.area = result.clamped ? 0.0 : std::sqrt(area2);
  return result;
}

void SixR::add_elbow(Arctangents& turns, const Triangle& triangle) const noexcept {
  const double a2 = geometry_.a2_mm;
  turns.add(triangle.area, triangle.distance2 - a2 * a2 - forearm_mm_ * forearm_mm_);
  turns.add(triangle.y, triangle.x);
  turns.add(triangle.area, triangle.distance2 + difference_mm2_);
}

SixR::Elbow SixR::elbow(const Arctangents& turns, std::size_t first, const Triangle& triangle,
                        double previous_rad) const noexcept {
  const double delta = turns[first], gamma = turns[first + 1], beta = turns[first + 2];
  const bool folded = (triangle.singular & kFoldedSingular) != 0;
  return {.theta2 = {wrapped(folded ? previous_rad : gamma + beta), wrapped(folded ? previous_rad : gamma - beta)},
          .theta3 = {wrapped(phi_rad_ - delta), wrapped(phi_rad_ + delta)}};
}

SixR::Arms SixR::arms(const Transform& base_T_flange, const Theta& previous) const noexcept {
  const Eigen::Vector3d centre = wrist_centre(base_T_flange);
  const Shoulder front = shoulder(centre, previous[0]), back = front.back();
  const auto side_of = [&](const Shoulder& s) {
    return Arms::Side{.shoulder = s, .triangle = triangle(centre, s), .hand{s, base_T_flange.rotation}};
  };
  Arms arms{.sides = {side_of(front), side_of(back)}};
  Arctangents turns;
  for (const Arms::Side& side : arms.sides) add_elbow(turns, side.triangle);
  turns.compute();
  for (const std::size_t side : {0u, 1u}) {
    const Triangle& arm = arms.sides[side].triangle;
    if (arm.margin_mm > 0.0) {
      arms.margin_mm = arms.margin_mm == 0.0 ? arm.margin_mm : std::min(arms.margin_mm, arm.margin_mm);
      continue;
    }
    const Elbow bends = elbow(turns, 3 * side, arm, previous[1]);
    for (const std::size_t bend : {0u, 1u}) {
      arms.posed[arms.count++] = {side, bend, bends.theta2[bend], bends.theta3[bend]};
    }
  }
  if (arms.count > 0) arms.margin_mm = 0.0;
  return arms;
}

std::size_t SixR::add_wrists(const Arms& arms, std::size_t first, std::size_t count, double previous_theta4,
                             std::span<RawBranch> branches) noexcept {
  const std::span posed = std::span{arms.posed}.subspan(first, count);
  std::array<double, Arms::kMax> theta23;
  std::array<math::SinCos, Arms::kMax> turned;
  std::array<bool, Arms::kMax> singular;
  for (std::size_t i = 0; i < count; ++i) theta23[i] = posed[i].theta2 + posed[i].theta3;
  math::sin_cos_each(std::span{theta23}.first(count), std::span{turned}.first(count));
  Arctangents turns;
  for (std::size_t i = 0; i < count; ++i) {
    singular[i] = Wrist::add_to(turns, arms.sides[posed[i].side].hand, turned[i], kWristZone, previous_theta4);
  }
  turns.compute();
  std::size_t added = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Arms::Posed& arm = posed[i];
    const Arms::Side& side = arms.sides[arm.side];
    const auto add = [&](const Wrist& w, int flip) {
      RawBranch& branch = branches[added++];
      branch.theta = {side.shoulder.theta1, arm.theta2, arm.theta3, w.theta4, w.theta5, w.theta6};
      branch.shoulder = arm.side == 0 ? 1 : -1;
      branch.elbow = arm.bend == 0 ? 1 : -1;
      branch.flip = static_cast<std::int8_t>(flip);
      branch.singular = singular_mask(side.shoulder.singular, side.triangle.singular, w.singular);
      branch.clamped = side.triangle.clamped;
    };
    const Wrist wrist = Wrist::from(turns, 3 * i, singular[i], previous_theta4);
    add(wrist, +1);
    if (!wrist.singular) add(wrist.other(), -1);
  }
  return added;
}

RawSolutions SixR::inverse(const Transform& base_T_flange, const Theta& previous) const noexcept {
  RawSolutions solutions;
  if (!is_rigid(base_T_flange) || !are_angles(previous)) {
    solutions.status = IkStatus::kInvalidInput;
    return solutions;
  }
  const Arms arms = this->arms(base_T_flange, previous);
  solutions.margin_mm = arms.margin_mm;
  if (arms.count == 0) return solutions;
  solutions.count = add_wrists(arms, 0, arms.count, previous[3], solutions.branches);
  solutions.status = IkStatus::kOk;
  return solutions;
}

RawTracking SixR::track(const Transform& base_T_flange, const Theta& previous, double wrist_zone,
                        bool keep_elbow) const noexcept {
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
  const Triangle sides = triangle(centre, here);
  Arctangents elbow_turns;
  add_elbow(elbow_turns, sides);
  elbow_turns.compute();
  const Elbow arm = elbow(elbow_turns, 0, sides, previous[1]);
  const Hand hand{here, base_T_flange.rotation};
  double theta2[2], theta3[2], least[2];  // least: no wrist gives a smaller step of this elbow
  for (std::size_t i = 0; i < 2; ++i) {
    theta2[i] = nearest_turn(arm.theta2[i], previous[1]);
    theta3[i] = nearest_turn(arm.theta3[i], previous[2]);
    least[i] = std::max(std::fabs(theta2[i] - previous[1]), std::fabs(theta3[i] - previous[2]));
  }
  const std::size_t nearer = least[0] <= least[1] ? 0 : 1;
  JointStep best;
  for (const std::size_t i : {nearer, 1 - nearer}) {
    if (least[i] > best.largest || (keep_elbow && i != nearer)) break;
    Arctangents wrist_turns;
    const bool singular =
        Wrist::add_to(wrist_turns, hand, math::sin_cos(arm.theta2[i] + arm.theta3[i]), wrist_zone, previous[3]);
    wrist_turns.compute();
    const Wrist wrist = Wrist::from(wrist_turns, 0, singular, previous[3]);
    const auto consider = [&](const Wrist& w) {
      const Theta theta{theta1,
                        theta2[i],
                        theta3[i],
                        nearest_turn(w.theta4, previous[3]),
                        nearest_turn(w.theta5, previous[4]),
                        nearest_turn(w.theta6, previous[5])};
      const JointStep step{theta, previous};
      if (step.shorter_than(best)) {
        best = step;
        result.theta = theta;
        result.singular = singular_mask(here.singular, sides.singular, w.singular);
      }
    };
    consider(wrist);
    if (!wrist.singular) consider(wrist.other());
  }
  result.found = true;
  result.margin_mm = sides.margin_mm;
  result.status = sides.margin_mm > 0.0 ? IkStatus::kUnreachable : status_of(result.singular, sides.clamped);
  return result;
}

}  // namespace armature
