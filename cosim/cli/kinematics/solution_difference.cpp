#include "cosim/cli/kinematics/solution_difference.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "controller/kinematics/turns.hpp"
#include "controller/robot/axis_units.hpp"

namespace armature::cosim {

SolutionDifference difference(const IkSolutions& solutions, const IkSolutions& host, const RobotModel& model) {
  SolutionDifference found{.other_branches = host.count};
  const std::span branches = std::span{host.branches}.first(host.count);
  for (std::size_t i = 0; i < solutions.count; ++i) {
    const IkBranch& branch = solutions.branches[i];
    const auto same = std::ranges::find_if(branches, [&branch](const IkBranch& other) {
      return other.shoulder == branch.shoulder && other.elbow == branch.elbow && other.flip == branch.flip;
    });
    if (same == branches.end()) {
      ++found.other_branches;
      continue;
    }
    --found.other_branches;
    for (std::size_t joint = 0; joint < model.axis_count; ++joint) {
      const double rad = std::remainder((branch.joints[joint] - same->joints[joint]).value(), kTurn_rad);
      const double pulses = std::fabs(rad / AxisUnits{model.axes[joint]}.rad_per_pulse());
      if (pulses <= found.pulses) continue;
      found.pulses = pulses;
      found.branch = i;
      found.joint = joint;
    }
  }
  return found;
}

}  // namespace armature::cosim
