#include "cosim/engine/chip_inverse.hpp"

#include <cstddef>
#include <optional>
#include <utility>

#include "controller/drivers/ik_cordic.hpp"
#include "controller/kinematics/five_r.hpp"
#include "controller/kinematics/fixed/fixed_point.hpp"
#include "controller/kinematics/six_r.hpp"
#include "controller/motion/cordic/cordic_words.hpp"
#include "cosim/engine/chip_bus.hpp"

namespace armature::cosim {
namespace {

constexpr std::int8_t sign(std::size_t index, std::size_t bit) {
  return (index & bit) != 0 ? std::int8_t{-1} : std::int8_t{1};
}

// Branch `index` of the block.
RawBranch branch_at(IkCordic& block, const IkCordic::Flags& flags, std::size_t index, bool five_r) {
  RawBranch branch{
      .shoulder = sign(index, 4), .elbow = sign(index, 2), .flip = five_r ? std::int8_t{0} : sign(index, 1)};
  for (std::size_t joint = 0; joint < (five_r ? 5u : 6u); ++joint) {
    branch.theta[joint] = radians_of(block.theta(index, joint));
  }
  const auto is_set = [](std::uint8_t mask, std::size_t bit) { return (mask >> bit & 1u) != 0; };
  const std::size_t shoulder = index / 4, posture = index / 2;
  branch.singular = static_cast<std::uint8_t>((flags.shoulder_singular ? kShoulderSingular : 0) |
                                              (is_set(flags.elbow_singular, shoulder) ? kElbowSingular : 0) |
                                              (is_set(flags.folded, shoulder) ? kFoldedSingular : 0) |
                                              (is_set(flags.wrist_singular, posture) ? kWristSingular : 0));
  branch.clamped = is_set(flags.clamped, shoulder);
  return branch;
}

}  // namespace

ChipInverse::ChipInverse(const RobotModel& robot, std::unique_ptr<Soc> soc) : robot_{robot}, soc_{std::move(soc)} {}

RawSolutions ChipInverse::inverse(const Transform& base_T_flange, const Theta& previous) noexcept {
  block_clocks_ = 0;
  clocks_ = {};
  const bool five_r = robot_.arm.family == ArmFamily::kFiveR;
  const FiveR five_axes{robot_.arm};
  const RawSolutions software =
      five_r ? five_axes.inverse(base_T_flange, previous) : SixR{robot_.arm}.inverse(base_T_flange, previous);
  const std::optional<FixedArm> arm = fixed_arm(robot_.arm);
  const std::optional<FixedPose> pose =
      fixed_pose(five_r && software.count > 0 ? five_axes.forward(software.branches[0].theta) : base_T_flange, *arm);
  if (!pose || (software.count == 0 && software.status != IkStatus::kUnreachable)) return software;

  ChipBus bus{*soc_};
  IkCordic block{bus};
  block.set_geometry(geometry_words(*arm));
  const Cycles begin = bus.now();
  for (std::size_t i = 0; i < pose->rotation.size(); ++i) block.set_rotation(i, pose->rotation[i]);
  for (std::size_t i = 0; i < pose->position.size(); ++i) block.set_position(i, pose->position[i]);
  block.set_previous({binary_angle(previous[0]), binary_angle(previous[1]), binary_angle(previous[3])});
  block.start(five_r);
  constexpr int kMostReads = 1000;  // far more than any run takes
  for (int reads = 0; reads < kMostReads && !block.done(); ++reads) {
  }
  RawSolutions solutions{.status = IkStatus::kOk, .residual_rad = software.residual_rad};
  const std::uint8_t valid = block.branches();
  const IkCordic::Flags flags = block.flags();
  for (std::size_t index = 0; index < IkCordic::kBranches; ++index) {
    if ((valid >> index & 1u) == 0) continue;
    solutions.branches[solutions.count++] = branch_at(block, flags, index, five_r);
  }
  clocks_ = bus.now() - begin;
  block_clocks_ = block.cycles();
  return solutions.count == 0 ? software : solutions;
}

RawTracking ChipInverse::track(const Transform& base_T_flange, const Theta& previous, double wrist_zone,
                               bool keep_elbow) noexcept {
  if (robot_.arm.family == ArmFamily::kFiveR) return FiveR{robot_.arm}.track(base_T_flange, previous);
  return SixR{robot_.arm}.track(base_T_flange, previous, wrist_zone, keep_elbow);
}

RawTracking ChipInverse::track_point(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& flange_p_mm,
                                     const Theta& previous) noexcept {
  return SixR{robot_.arm}.track_point(point_mm, flange_p_mm, previous);
}

}  // namespace armature::cosim
