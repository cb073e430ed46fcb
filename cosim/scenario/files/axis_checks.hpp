// Checks of several keys of an axis, each of which is allowed by itself.
#pragma once

#include <cstddef>
#include <vector>

#include "cosim/robot/robot_spec.hpp"
#include "cosim/scenario/toml/config_value.hpp"

namespace armature::cosim {

// An axis whose keys are valid one by one: axis[index] of the file.
struct ReadAxis {
  std::size_t index = 0;
  AxisSpec spec;
};

// Adds a problem for each mistake. A mistake that several axes inherit from [defaults] is one problem at that key, with
// the numbers of the worst axis. `root` is the robot file.
void check_axes(const ConfigValue& root, const std::vector<ReadAxis>& axes, ProblemList& problems);

}  // namespace armature::cosim
