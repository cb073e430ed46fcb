#include "controller/language/robot/rconf.hpp"

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
constexpr int kMostTurnsTried = 3;

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

// The angle plus whole turns that has this turn bit, is within the limits and nearest to `previous_rad`.
std::optional<double> with_turn_bit(double angle_rad, bool beyond, const AxisModel& axis,
                                    double previous_rad) noexcept {
  const JointRange range{axis.min_rad, axis.max_rad, 1.0};
  const double from = within_turn(angle_rad);
  std::optional<double> best;
  for (int turns = -kMostTurnsTried; turns <= kMostTurnsTried; ++turns) {
    double angle = from + turns * kTurn_rad;
    if (turns == 0 && angle_rad == from) angle = angle_rad;
    if (beyond_half_turn(angle) != beyond || limit_excess(angle, range) > 0.0) continue;
    if (!best || std::fabs(angle - previous_rad) < std::fabs(*best - previous_rad)) best = angle;
  }
  return best;
}

}  // namespace

std::uint8_t rconf_of(const Arm& arm, const JointAngles& joints) noexcept {
  unsigned bits = sides(arm.configuration(joints), joints);
  for (std::size_t i = 0; i < kTurningAxes.size(); ++i) {
    if (beyond_half_turn(joints[kTurningAxes[i]].value())) bits |= 1U << (kFirstTurnBit + i);
  }
  return static_cast<std::uint8_t>(bits);
}

std::optional<JointAngles> joints_of(const RobotModel& robot, const Arm& arm, const Transform& base_T_flange,
                                     std::uint8_t rconf, const JointAngles& previous) noexcept {
  const IkSolutions solutions = arm.inverse(base_T_flange, previous);
  for (std::size_t i = 0; i < solutions.count; ++i) {
    const IkBranch& branch = solutions.branches[i];
    if (sides(Arm::configuration(branch), branch.joints) != (rconf & 0b111)) continue;
    JointAngles joints = branch.joints;
    bool inside = true;
    for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
      double angle = joints[axis].value();
      for (std::size_t t = 0; t < kTurningAxes.size(); ++t) {
        if (kTurningAxes[t] != axis) continue;
        const bool beyond = (rconf >> (kFirstTurnBit + t) & 1U) != 0;
        const auto turned = with_turn_bit(angle, beyond, robot.axes[axis], previous[axis].value());
        inside = inside && turned.has_value();
        angle = turned.value_or(angle);
      }
      const AxisModel& limits = robot.axes[axis];
      inside = inside && limit_excess(angle, {limits.min_rad, limits.max_rad, 1.0}) == 0.0;
      joints[axis] = Radians{angle};
    }
    if (inside) return joints;
  }
  return std::nullopt;
}

}  // namespace armature::job
