#include "controller/kinematics/arm.hpp"

#include <algorithm>
#include <type_traits>

#include "controller/base/math.hpp"
#include "controller/kinematics/turns.hpp"
#include "controller/robot/axis_units.hpp"

namespace armature {

namespace {

// Below this |sin| of the angle between the links both elbows differ by rounding only. The second value, far above
// rounding and far below a pulse, sets theta_3 to one side.
constexpr double kStretched = 1e-7;
constexpr double kAside_rad = 1e-6;

// Columns of the Jacobian get the vendor's sign of their joint.
Jacobian with_signs(Jacobian jacobian, const PerAxis<double>& sign) noexcept {
  for (std::size_t axis = 0; axis < kAxes; ++axis) jacobian.col(static_cast<Eigen::Index>(axis)) *= sign[axis];
  return jacobian;
}

JointRange range_of(const AxisModel& axis) noexcept {
  return {axis.min_rad, axis.max_rad, AxisUnits{axis}.max_speed_rad_s()};
}

std::variant<std::monostate, SixR, FiveR> family_of(const ArmGeometry& geometry) noexcept {
  switch (geometry.family) {
    case ArmFamily::kSixR:
      return SixR{geometry};
    case ArmFamily::kFiveR:
      return FiveR{geometry};
    case ArmFamily::kNone:
      break;
  }
  return std::monostate{};
}

}  // namespace

Arm::Arm(const RobotModel& robot) noexcept
    : geometry_{robot.arm},
      ranges_{make_per_axis([&](std::size_t axis) {
        // Joints that the arm does not have stay at 0.
        return axis < robot.axis_count ? range_of(robot.axes[axis]) : JointRange{};
      })},
      family_{family_of(robot.arm)} {}

// Both families have the same shape.
template <class None, class Call>
auto Arm::dispatch(None none, Call call) const noexcept {
  if (const auto* six_r = std::get_if<SixR>(&family_)) return call(*six_r);
  if (const auto* five_r = std::get_if<FiveR>(&family_)) return call(*five_r);
  return none();
}

Theta Arm::to_theta(const JointAngles& joints) const noexcept {
  return make_per_axis(
      [&](std::size_t axis) { return geometry_.sign[axis] * joints[axis].value() + geometry_.offset_rad[axis]; });
}

JointAngles Arm::to_joints(const Theta& theta) const noexcept {
  return make_per_axis(
      [&](std::size_t axis) { return Radians{geometry_.sign[axis] * (theta[axis] - geometry_.offset_rad[axis])}; });
}

Transform Arm::forward(const JointAngles& joints) const noexcept {
  return dispatch([] { return Transform{}; }, [&](const auto& family) { return family.forward(to_theta(joints)); });
}

IkSolutions Arm::inverse(const Transform& base_T_flange, const JointAngles& previous,
                         const Configuration& wanted) const noexcept {
  IkSolutions solutions;
  const RawSolutions raw = dispatch([] { return RawSolutions{.status = IkStatus::kInvalidInput}; },
                                    [&](const auto& family) {
                                      const Theta theta = to_theta(previous);
                                      if (solver_ != nullptr) return solver_->inverse(base_T_flange, theta);
                                      return family.inverse(base_T_flange, theta);
                                    });
  solutions.status = raw.status;
  solutions.margin_mm = raw.margin_mm;
  solutions.residual_rad = raw.residual_rad;
  const std::uint8_t requested = requested_parts(wanted);
  std::uint8_t missing = requested;
  for (std::size_t i = 0; i < raw.count; ++i) {
    const RawBranch& from = raw.branches[i];
    IkBranch& to = solutions.branches[solutions.count];
    to.joints = to_joints(from.theta);
    to.shoulder = from.shoulder;
    to.elbow = from.elbow;
    to.flip = from.flip;
    to.singular = from.singular;
    to.clamped = from.clamped;
    const std::uint8_t differs = requested != 0 ? differing_sides(wanted, configuration(to)) : std::uint8_t{0};
    missing &= differs;
    if (differs == 0) ++solutions.count;
  }
  if (raw.count > 0 && solutions.count == 0) {
    solutions.status = IkStatus::kConfiguration;
    solutions.configuration = missing != 0 ? missing : static_cast<std::uint8_t>(requested & ~kTurnsPart);
  }
  if (!wanted.turns) {
    choose_branch(solutions, previous, ranges_);
    return solutions;
  }
  choose_branch(solutions, previous, ranges_with(*wanted.turns));
  for (std::size_t axis = 0; axis < kAxes && solutions.selected >= 0; ++axis) {
    const IkBranch& selected = solutions.branches[static_cast<std::size_t>(solutions.selected)];
    if (has_turns(selected.joints[axis].value(), (*wanted.turns)[axis])) continue;
    solutions.selected = -1;
    solutions.status = IkStatus::kOutsideLimits;
    solutions.axis = static_cast<std::uint8_t>(axis + 1);
    solutions.angle_rad = selected.joints[axis].value();
  }
  if (solutions.status == IkStatus::kOutsideLimits) {
    const std::int8_t turns = (*wanted.turns)[solutions.axis - 1U];
    solutions.angle_rad = nearest_turn(solutions.angle_rad, turns * kTurn_rad);
  }
  return solutions;
}

// The limits within these turns. A joint that cannot have its turns keeps the limit next to them.
PerAxis<JointRange> Arm::ranges_with(const Turns& turns) const noexcept {
  PerAxis<JointRange> ranges = ranges_;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    JointRange& range = ranges[axis];
    const double middle_rad = turns[axis] * kTurn_rad;
    const double low = middle_rad - 0.5 * kTurn_rad, high = middle_rad + 0.5 * kTurn_rad;
    range.min_rad = std::clamp(low, range.min_rad, range.max_rad);
    range.max_rad = std::clamp(high, range.min_rad, range.max_rad);
  }
  return ranges;
}

Configuration Arm::configuration(const IkBranch& branch) noexcept {
  const auto sign = [&branch](std::int8_t flag, std::uint8_t singularity) {
    return (branch.singular & singularity) != 0 ? 0 : flag;
  };
  return configuration_of(sign(branch.shoulder, kShoulderSingular), sign(branch.elbow, kElbowSingular),
                          sign(branch.flip, kWristSingular));
}

Configuration Arm::configuration(const JointAngles& joints) const noexcept {
  const RawSides sides =
      dispatch([] { return RawSides{}; }, [&](const auto& family) { return family.sides(to_theta(joints)); });
  const auto sign = [](double side, double undecided) { return side > undecided ? 1 : side < -undecided ? -1 : 0; };
  Configuration result = configuration_of(sign(sides.shoulder, Undecided::kShoulder),
                                          sign(sides.elbow, Undecided::kElbow), sign(sides.flip, Undecided::kWrist));
  Turns& turns = result.turns.emplace();
  for (std::size_t axis = 0; axis < kAxes; ++axis) turns[axis] = turns_of(joints[axis].value());
  return result;
}

IkTracking Arm::track(const Transform& base_T_flange, const JointAngles& previous) const noexcept {
  const auto from = [&](const Theta& theta) { return track(base_T_flange, theta, SixR::kTrackingWristZone); };
  const Theta theta = to_theta(previous);
  const IkTracking tracking = from(theta);
  if (tracking.status != IkStatus::kOutsideLimits || manipulability(previous).elbow >= kStretched) return tracking;
  for (const double aside_rad : {kAside_rad, -kAside_rad}) {
    Theta bent = theta;
    bent[2] += aside_rad;
    const IkTracking other = from(bent);
    if (solved(other.status)) return other;
  }
  return tracking;
}

IkTracking Arm::track(const Transform& base_T_flange, const Theta& previous, double wrist_zone,
                      bool keep_elbow) const noexcept {
  return within_limits(dispatch([] { return RawTracking{.status = IkStatus::kInvalidInput}; },
                                [&]<class Family>(const Family& family) {
                                  if (solver_ != nullptr)
                                    return solver_->track(base_T_flange, previous, wrist_zone, keep_elbow);
                                  if constexpr (std::is_same_v<Family, SixR>)
                                    return family.track(base_T_flange, previous, wrist_zone, keep_elbow);
                                  else
                                    return family.track(base_T_flange, previous);
                                }));
}

IkTracking Arm::track_keeping_elbow(const Transform& base_T_flange, const JointAngles& previous) const noexcept {
  if (!std::holds_alternative<SixR>(family_)) return track(base_T_flange, previous);
  return track(base_T_flange, to_theta(previous), SixR::kTrackingWristZone, true);
}

IkTracking Arm::track_keeping_theta4(const Transform& base_T_flange, const JointAngles& previous) const noexcept {
  if (!std::holds_alternative<SixR>(family_)) return track(base_T_flange, previous);
  return track(base_T_flange, to_theta(previous), SixR::kKeepTheta4);
}

IkTracking Arm::track_point(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& flange_p_mm,
                            const JointAngles& previous) const noexcept {
  const auto* six_r = std::get_if<SixR>(&family_);
  if (six_r == nullptr) return {.status = IkStatus::kInvalidInput};
  const Theta theta = to_theta(previous);
  return within_limits(solver_ != nullptr ? solver_->track_point(point_mm, flange_p_mm, theta)
                                          : six_r->track_point(point_mm, flange_p_mm, theta));
}

Eigen::Vector2d Arm::approach_in_forearm(const JointAngles& joints) const noexcept {
  if (!std::holds_alternative<SixR>(family_)) return {1.0, 0.0};
  const Theta theta = to_theta(joints);
  const auto [s4, c4] = math::sin_cos(theta[3]);
  const double s5 = math::sin(theta[4]);
  return {s5 * c4, s5 * s4};
}

double Arm::wrist_sine(const JointAngles& joints) const noexcept {
  return std::holds_alternative<SixR>(family_) ? math::sin(to_theta(joints)[4]) : 1.0;
}

IkTracking Arm::within_limits(const RawTracking& raw) const noexcept {
  IkTracking tracking;
  tracking.found = raw.found;
  tracking.status = raw.status;
  tracking.singular = raw.singular;
  tracking.margin_mm = raw.margin_mm;
  tracking.residual_rad = raw.residual_rad;
  if (!raw.found) return tracking;

  tracking.joints = to_joints(raw.theta);
  double worst_rad = 0.0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    double joint_rad = tracking.joints[axis].value();
    const double excess_rad = limit_excess(joint_rad, ranges_[axis]);
    tracking.joints[axis] = Radians{joint_rad};
    if (excess_rad > worst_rad && solved(raw.status)) {
      worst_rad = excess_rad;
      tracking.status = IkStatus::kOutsideLimits;
      tracking.axis = static_cast<std::uint8_t>(axis + 1);
    }
  }
  return tracking;
}

Jacobian Arm::jacobian(const JointAngles& joints) const noexcept {
  return with_signs(dispatch([] { return Jacobian{Jacobian::Zero()}; },
                             [&](const auto& family) { return family.jacobian(to_theta(joints)); }),
                    geometry_.sign);
}

Manipulability Arm::manipulability(const JointAngles& joints) const noexcept {
  return dispatch([] { return Manipulability{}; },
                  [&](const auto& family) { return family.manipulability(to_theta(joints)); });
}

Singularity Arm::nearest_singularity(const JointAngles& joints, double near) const noexcept {
  const Manipulability m = manipulability(joints);
  const double nearest = std::min({m.shoulder, m.elbow, m.wrist});
  if (!(nearest < near)) return kNotSingular;
  return m.wrist == nearest ? kWristSingular : m.elbow == nearest ? kElbowSingular : kShoulderSingular;
}

PerAxis<double> Arm::joint_rates(const JointAngles& joints, const Eigen::Vector3d& v_mm_s,
                                 const Eigen::Vector3d& w_rad_s) const noexcept {
  return joint_rates(posture(joints), v_mm_s, w_rad_s);
}

SixRPosture Arm::posture(const JointAngles& joints) const noexcept {
  const auto* six_r = std::get_if<SixR>(&family_);
  return six_r != nullptr ? six_r->posture(to_theta(joints)) : SixRPosture{};
}

Transform Arm::flange_at(const SixRPosture& posture) const noexcept {
  const auto* six_r = std::get_if<SixR>(&family_);
  return six_r != nullptr ? six_r->flange_at(posture) : Transform{};
}

PerAxis<double> Arm::joint_rates(const SixRPosture& posture, const Eigen::Vector3d& v_mm_s,
                                 const Eigen::Vector3d& w_rad_s) const noexcept {
  PerAxis<double> rates{};
  const auto* six_r = std::get_if<SixR>(&family_);
  if (six_r == nullptr) return rates;
  rates = six_r->rates(posture, v_mm_s, w_rad_s);
  for (std::size_t axis = 0; axis < kAxes; ++axis) rates[axis] *= geometry_.sign[axis];
  return rates;
}

}  // namespace armature
