#include "cosim/cli/kinematics/chip_solutions.hpp"

#include <fmt/format.h>

#include "cosim/engine/chip_inverse.hpp"
#include "cosim/engine/make_soc.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

double microseconds(Cycles clocks) {
  return to_seconds(clocks) * 1e6;
}

}  // namespace

void ChipSolutions::add_to(nlohmann::ordered_json& json) const {
  json["block_clocks"] = block_clocks;
  json["clocks"] = clocks.value();
  json["difference_pulses"] = difference.pulses;
  json["other_branches"] = difference.other_branches;
}

std::string ChipSolutions::text() const {
  if (block_clocks == 0) return "by the host: the pose does not reach ik_cordic\n";
  std::string text =
      fmt::format("by ik_cordic of the chip: {} clocks ({:.2f} us), {} with the bus ({:.2f} us)\n", block_clocks,
                  microseconds(Cycles{block_clocks}), clocks.value(), microseconds(clocks));
  if (solutions.count > 0) {
    text += fmt::format("largest difference from the host: {:.4f} pulses, joint {} of branch {}\n", difference.pulses,
                        difference.joint + 1, difference.branch);
  }
  if (difference.other_branches > 0) {
    text += fmt::format("branches that only one of them has: {}\n", difference.other_branches);
  }
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
  solved.difference = difference(solved.solutions, robot.arm.inverse(base_T_flange, previous), robot.model);
  return solved;
}

}  // namespace armature::cosim
