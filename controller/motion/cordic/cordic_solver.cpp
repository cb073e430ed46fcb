#include "controller/motion/cordic/cordic_solver.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/math.hpp"
#include "controller/kinematics/turns.hpp"
#include "controller/motion/cordic/cordic_words.hpp"
#include "controller/robot/axis_units.hpp"

namespace armature {
namespace {

// The stated error in pulses of a motor with 10 000 pulses per revolution and a gear of 50:1. For six axes theta_4 and
// theta_6 have kWrist + kOverSine / sin(theta_5).
constexpr double kStatedPulse_rad = kTurn_rad / 500'000.0;
constexpr double kAnyJoint = 0.013, kWrist = 0.03, kOverSine = 0.0075;

// The block answers within half a tick, after far fewer reads of its status.
constexpr int kMostReads = 300;

std::variant<SixR, FiveR> solved_family(const ArmGeometry& geometry) noexcept {
  if (geometry.family == ArmFamily::kFiveR) return FiveR{geometry};
  return SixR{geometry};
}

}  // namespace

CordicSolver::CordicSolver(RegisterBus& bus, const RobotModel& robot) noexcept
    : bus_{bus},
      block_{bus},
      arm_{fixed_arm(robot.arm).value_or(FixedArm{})},
      family_{solved_family(robot.arm)},
      rad_per_pulse_{make_per_axis([&](std::size_t axis) {
        return axis < robot.axis_count ? std::fabs(AxisUnits{robot.axes[axis]}.rad_per_pulse()) : 1.0;
      })} {}

void CordicSolver::start() noexcept {
  check_.usable = block_.identified();
  if (!check_.usable) return;
  block_.set_geometry(geometry_words(arm_));
}

RawTracking CordicSolver::track_in_software(const Transform& base_T_flange, const Theta& previous, double wrist_zone,
                                            bool keep_elbow) const noexcept {
  if (const auto* five_r = std::get_if<FiveR>(&family_)) return five_r->track(base_T_flange, previous);
  return std::get<SixR>(family_).track(base_T_flange, previous, wrist_zone, keep_elbow);
}

RawTracking CordicSolver::track(const Transform& base_T_flange, const Theta& previous, double wrist_zone,
                                bool keep_elbow) noexcept {
  const auto in_software = [&] { return track_in_software(base_T_flange, previous, wrist_zone, keep_elbow); };
  if (wrist_zone > SixR::kTrackingWristZone || !is_rigid(base_T_flange)) return in_software();
  if (const auto* five_r = std::get_if<FiveR>(&family_)) {
    // A pose that the arm meets only nearly is projected first, as the block requires.
    RawTracking found = in_software();
    if (found.found && start(five_r->forward(found.theta))) use_block(found);
    return found;
  }
  if (!start(base_T_flange)) return in_software();
  // Software solves the pose meanwhile.
  bus_.charge(Work::kInverse);
  ++check_.charged;
  RawTracking found = in_software();
  use_block(found);
  return found;
}

// Waits for the block, and takes its angles where they have a stated error.
void CordicSolver::use_block(RawTracking& found) noexcept {
  const RawSides sides = std::visit([&](const auto& family) { return family.sides(found.theta); }, family_);
  const bool usable = found.found && found.status == IkStatus::kOk && is_regular(found.theta, sides);
  if (!wait()) {
    check_.differs = true;
    return;
  }
  if (!usable) return;
  const std::size_t branch = branch_of(sides);
  Theta theta = found.theta;
  const std::size_t joints = arm_.five_r ? 5 : 6;
  for (std::size_t joint = 0; joint < joints; ++joint) {
    theta[joint] = nearest_turn(radians_of(block_.theta(branch, joint)), found.theta[joint]);
  }
  if (agrees(theta, found.theta, sides)) found.theta = theta;
}

RawTracking CordicSolver::track_point(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& flange_p_mm,
                                      const Theta& previous) noexcept {
  if (arm_.five_r) return {.status = IkStatus::kInvalidInput};
  return std::get<SixR>(family_).track_point(point_mm, flange_p_mm, previous);
}

RawSolutions CordicSolver::inverse(const Transform& base_T_flange, const Theta& previous) noexcept {
  return std::visit([&](const auto& family) { return family.inverse(base_T_flange, previous); }, family_);
}

bool CordicSolver::is_regular(const Theta& theta, const RawSides& sides) const noexcept {
  const auto manipulability = [&](const auto& family) { return family.manipulability(theta, sides); };
  const Manipulability is = std::visit(manipulability, family_);
  return std::min({is.shoulder, is.elbow, is.wrist}) >= kLeastSine;
}

std::size_t CordicSolver::branch_of(const RawSides& sides) noexcept {
  return (sides.shoulder < 0 ? 4u : 0u) + (sides.elbow < 0 ? 2u : 0u) + (sides.flip < 0 ? 1u : 0u);
}

// Only what has changed: the orientation of many paths is constant.
void CordicSolver::write(const FixedPose& pose) noexcept {
  for (std::size_t i = 0; i < pose.rotation.size(); ++i) {
    if (!written_ || written_->rotation[i] != pose.rotation[i]) block_.set_rotation(i, pose.rotation[i]);
  }
  for (std::size_t i = 0; i < pose.position.size(); ++i) {
    if (!written_ || written_->position[i] != pose.position[i]) block_.set_position(i, pose.position[i]);
  }
  written_ = pose;
}

// False: the pose is beyond every reach.
bool CordicSolver::start(const Transform& base_T_flange) noexcept {
  const std::optional<FixedPose> pose = fixed_pose(base_T_flange, arm_);
  if (!pose) return false;
  write(*pose);
  block_.start(arm_.five_r);
  return true;
}

bool CordicSolver::wait() noexcept {
  for (int reads = 0; reads < kMostReads; ++reads) {
    if (block_.done()) return true;
  }
  return false;
}

bool CordicSolver::agrees(const Theta& block, const Theta& software, const RawSides& sides) noexcept {
  const double wrist = arm_.five_r ? kAnyJoint : kWrist + kOverSine / std::fabs(sides.flip);
  for (std::size_t joint = 0; joint < kAxes; ++joint) {
    const double difference_rad = std::fabs(block[joint] - software[joint]);
    const double stated = joint == 3 || joint == 5 ? wrist : kAnyJoint;
    check_.difference_pulses = std::max(check_.difference_pulses, difference_rad / rad_per_pulse_[joint]);
    if (difference_rad <= stated * kStatedPulse_rad) continue;
    check_.differs = true;
    check_.differing_axis = static_cast<std::uint8_t>(joint + 1);
    return false;
  }
  ++check_.solved;
  return true;
}

}  // namespace armature
