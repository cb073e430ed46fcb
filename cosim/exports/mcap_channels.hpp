// The channels of an exported run, and the JSON Schemas of their messages.
#pragma once

#include <cstddef>
#include <vector>

#include "cosim/exports/mcap_writer.hpp"

namespace armature::cosim {

// Places in the list of channels.
enum RunChannel : std::size_t {
  kJointStates,     // /joint_states, of the encoders
  kJointSetPoints,  // /joint_set_points
  kToolPose,        // /tool_pose, of the encoders
  kToolSetPoint,    // /tool_set_point
  kTransforms,      // /tf: links, tool, frames of the scenario
  kMotionState,     // /state
  kRunEvents,       // /events
  kArmLine,         // /program/arm: the line that moves the arm
  kReadLine,        // /program/core1: the line that core 1 reads
  kCoreLoad,        // /cores
};

// Names that begin with foxglove are those that Foxglove shows in its panels.
[[nodiscard]] std::vector<McapChannel> run_channels();

}  // namespace armature::cosim
