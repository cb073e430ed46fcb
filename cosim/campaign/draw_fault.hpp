// Draws a fault of any kind. The kinds, their keys and the ranges of these are those of the tables of the scenario
// (cosim/scenario/tables/fault_kinds.hpp): a new kind is drawn without a change here.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cosim/campaign/draw.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

// The names of all kinds that need no inside of a part, in the order of FaultKind.
[[nodiscard]] const std::vector<std::string_view>& fault_kind_names();

// The keys of a table [[fault]] that begins at `at_s`, of one of the kinds `names`, which are of fault_kind_names();
// empty: of all. The loader may refuse them, as values can exclude each other.
[[nodiscard]] std::string draw_fault(Draw& draw, const RobotSpec& robot, double at_s,
                                     const std::vector<std::string>& names = {});

}  // namespace armature::cosim
