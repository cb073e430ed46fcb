// The commands of a step of the operator.
#pragma once

#include <vector>

#include "controller/pendant/protocol/frame.hpp"
#include "cosim/pendant/pendant_spec.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

// Of kSend and kMove: all commands, in their order; of kDownload the first one; of others none. The sequence numbers
// are not set.
[[nodiscard]] std::vector<pendant::Frame> frames_of(const PendantStepSpec& step, const RobotSpec& robot);

// The command that keeps the key of a kJog pressed.
[[nodiscard]] pendant::Frame jog_frame(const PendantStepSpec& step);

}  // namespace armature::cosim
