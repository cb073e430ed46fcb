// Draws what a run does: a robot, its moves or its program.
//
// The first two steps move each axis there and back, past the index at the start: a real arm has passed its indexes
// when it was homed. The last step turns each motor by more than two turns. So the check of the indexes sees counts
// that are lost in between.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "controller/base/axes.hpp"
#include "cosim/campaign/campaign_case.hpp"
#include "cosim/campaign/draw.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

struct DrawnMoves {
  CampaignCase drawn;         // without faults
  PerAxis<double> end_deg{};  // where the run ends
};

// `robots` is not empty.
[[nodiscard]] DrawnMoves draw_moves(Draw& draw, const std::vector<RobotSpec>& robots);

}  // namespace armature::cosim
