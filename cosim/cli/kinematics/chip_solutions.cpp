#include "cosim/cli/kinematics/chip_solutions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "controller/kinematics/turns.hpp"
#include "controller/robot/axis_units.hpp"
#include "cosim/engine/chip_inverse.hpp"
#include "cosim/engine/make_soc.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

// Of the branches with the same sides.
void compare(ChipSolutions& chip, const IkSolutions& host, const RobotModel& model) {
  chip.other_branches = host.count;
  const std::span branches = std::span{host.branches}.first(host.count);
  for (std::size_t i = 0; i < chip.solutions.count; ++i) {
    const IkBranch& branch = chip.solutions.branches[i];
    const auto same = std::ranges::find_if(branches, [&branch](const IkBranch& other) {
      return other.shoulder == branch.shoulder && other.elbow == branch.elbow && other.flip == branch.flip;
    });
    if (same == branches.end()) {
      ++chip.other_branches;
      continue;
    }
    --chip.other_branches;
    for (std::size_t joint = 0; joint < model.axis_count; ++joint) {
      const double rad = std::remainder((branch.joints[joint] - same->joints[joint]).value(), kTurn_rad);
      const double pulses = std::fabs(rad / AxisUnits{model.axes[joint]}.rad_per_pulse());
      if (pulses <= chip.difference_pulses) continue;
      chip.difference_pulses = pulses;
      chip.branch = i;
      chip.joint = joint;
    }
  }
}

double microseconds(Cycles clocks) {
  return to_seconds(clocks) * 1e6;
}

}  // namespace

void ChipSolutions::add_to(nlohmann::ordered_json& json) const {
  json["block_clocks"] = block_clocks;
  json["clocks"] = clocks.value();
  json["difference_pulses"] = difference_pulses;
  json["other_branches"] = other_branches;
}

std::string ChipSolutions::text() const {
  if (block_clocks == 0) return "by the host: the pose does not reach ik_cordic\n";
  std::string text =
      fmt::format("by ik_cordic of the chip: {} clocks ({:.2f} us), {} with the bus ({:.2f} us)\n", block_clocks,
                  microseconds(Cycles{block_clocks}), clocks.value(), microseconds(clocks));
  if (solutions.count > 0) {
    text += fmt::format("largest difference from the host: {:.4f} pulses, joint {} of branch {}\n", difference_pulses,
                        joint + 1, branch);
  }
  if (other_branches > 0) text += fmt::format("branches that only one of them has: {}\n", other_branches);
  return text;
}

ChipSolutions solve_on_chip(const ArmOfFile& robot, const Transform& base_T_flange, const JointAngles& previous) {
  const Scenario defaults;
  ChipInverse chip{robot.model, make_soc(Variant::kCounts, Engine::kModel, defaults.bus, defaults.seed)};
  Arm arm = robot.arm;
  arm.solve_with(&chip);
  ChipSolutions solved;
  solved.solutions = arm.inverse(base_T_flange, previous);
  solved.block_clocks = chip.block_clocks();
  solved.clocks = chip.clocks();
  compare(solved, robot.arm.inverse(base_T_flange, previous), robot.model);
  return solved;
}

}  // namespace armature::cosim
