// The branches of a pose by the block ik_cordic of a chip, and how they differ from those of the host.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "controller/base/units.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/transform.hpp"
#include "cosim/cli/kinematics/solution_difference.hpp"
#include "cosim/cli/options/kinematics_io.hpp"

namespace armature::cosim {

struct ChipSolutions {
  IkSolutions solutions;
  std::uint32_t block_clocks = 0;  // 0: the pose did not reach the block, and the solutions are those of the host
  Cycles clocks{};                 // with all accesses of the bus
  SolutionDifference difference;   // from those of the host

  void add_to(nlohmann::ordered_json& json) const;
  [[nodiscard]] std::string text() const;  // lines below the table of solutions
};

// The chip is the model of the logic.
[[nodiscard]] ChipSolutions solve_on_chip(const ArmOfFile& robot, const Transform& base_T_flange,
                                          const JointAngles& previous);

}  // namespace armature::cosim
