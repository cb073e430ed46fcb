// How the branches that something else than the host has found differ from those of the host.
#pragma once

#include <cstddef>

#include "controller/kinematics/ik_result.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature::cosim {

struct SolutionDifference {
  double pulses = 0;  // the largest of a joint angle, in pulses of its motor, of this branch and joint
  std::size_t branch = 0, joint = 0;
  std::size_t other_branches = 0;  // those that only one of them has
};

// Of the branches with the same sides; whole turns of a joint do not count.
[[nodiscard]] SolutionDifference difference(const IkSolutions& solutions, const IkSolutions& host,
                                            const RobotModel& model);

}  // namespace armature::cosim
