#include "controller/language/job/state/rconf.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "controller/kinematics/branch_choice.hpp"
#include "controller/kinematics/turns.hpp"

namespace armature::job {
namespace {

constexpr std::size_t kAxisR = 3, kAxisT = 5, kAxisS = 0;
constexpr std::array<std::size_t, 3> kTurningAxes{kAxisR, kAxisT, kAxisS};  // of bits 3, 4 and 5
constexpr int kFirstTurnBit = 3;
constexpr int kMaxTurnsTried = 3;
// At these singularities an angle of a branch is that of the previous joints.
constexpr unsigned kFreeAngle = kShoulderSingular | kWristSingular | kFoldedSingular;

// The angle without whole turns, above -180 degrees up to 180.
double within_turn(double angle_rad) noexcept {
  const double angle = wrapped(angle_rad);
  return angle == -std::numbers::pi ? std::numbers::pi : angle;
}

bool beyond_half_turn(double angle_rad) noexcept {
  return angle_rad > std::numbers::pi || angle_rad <= -std::numbers::pi;
}

// Bits 0 to 2. Only the first one needs the joints.
std::uint8_t sides(const Configuration& configuration, const JointAngles& joints) noexcept {
  const double r = within_turn(joints[kAxisR].value());
  const bool no_flip = !(r > -std::numbers::pi / 2 && r <= std::numbers::pi / 2);
  return static_cast<std::uint8_t>((no_flip ? 1 : 0) | (configuration.elbow == ElbowSide::kDown ? 2 : 0) |
                                   (configuration.shoulder == ShoulderSide::kBack ? 4 : 0));
}

struct TurnedAngle {
  double rad = 0.0;
  bool several = false;  // other turns fit, too
};

// The angle plus whole turns that has this turn bit (none: any), is within the limits and nearest to `previous_rad`.
std::optional<TurnedAngle> with_turn_bit(double angle_rad, std::optional<bool> beyond, const AxisModel& axis,
                                         double previous_rad) noexcept {
  const JointRange range{axis.min_rad, axis.max_rad, 1.0};
  const double from = within_turn(angle_rad);
  std::optional<TurnedAngle> best;
  for (int turns = -kMaxTurnsTried; turns <= kMaxTurnsTried; ++turns) {
    double angle = from + turns * kTurn_rad;
    if (turns == 0 && angle_rad == from) angle = angle_rad;
    if ((beyond && beyond_half_turn(angle) != *beyond) || limit_excess(angle, range) > 0.0) continue;
    const bool several = best.has_value();
    if (!best || std::fabs(angle - previous_rad) < std::fabs(best->rad - previous_rad))
      best = TurnedAngle{.rad = angle};
    best->several = several;
  }
  return best;
}

// The turn bit that a posture states for an axis; none: it has no such bit.
std::optional<bool> turn_bit(std::uint8_t rconf, std::size_t axis) noexcept {
  for (std::size_t i = 0; i < kTurningAxes.size(); ++i) {
    if (kTurningAxes[i] == axis) return (rconf >> (kFirstTurnBit + i) & 1U) != 0;
  }
  return std::nullopt;
}

}  // namespace

std::uint8_t rconf_of(const Arm& arm, const JointAngles& joints) noexcept {
  unsigned bits = sides(arm.configuration(joints), joints);
  for (std::size_t i = 0; i < kTurningAxes.size(); ++i) {
    if (beyond_half_turn(joints[kTurningAxes[i]].value())) bits |= 1U << (kFirstTurnBit + i);
  }
  return static_cast<std::uint8_t>(bits);
}

std::optional<PostureJoints> joints_of(const RobotModel& robot, const Arm& arm, const Transform& base_T_flange,
                                       std::uint8_t rconf, const JointAngles& previous) noexcept {
  const IkSolutions solutions = arm.inverse(base_T_flange, previous);
  for (std::size_t i = 0; i < solutions.count; ++i) {
    const IkBranch& branch = solutions.branches[i];
    if (sides(Arm::configuration(branch), branch.joints) != (rconf & 0b111)) continue;
    PostureJoints found{.joints = branch.joints, .free_angle = (branch.singular & kFreeAngle) != 0};
    bool inside = true;
    for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
      double angle = branch.joints[axis].value();
      const auto turned = with_turn_bit(angle, turn_bit(rconf, axis), robot.axes[axis], previous[axis].value());
      inside = inside && turned.has_value();
      if (!inside) break;
      found.several_turns = found.several_turns || turned->several;
      found.joints[axis] = Radians{turned->rad};
    }
    if (inside) return found;
  }
  return std::nullopt;
}

}  // namespace armature::job
