// The file of a [[stream]]: one set-point a row.
//
//   time_s,j1_deg,...                                  one column for each joint of the robot
//   time_s,x_mm,y_mm,z_mm,roll_deg,pitch_deg,yaw_deg   the tool in the base; rotations about the fixed x, y, z axes
//
// The first time is 0. Two times differ by at least 0.001 s, and are rounded to ticks.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "cosim/scenario/stream_spec.hpp"

namespace armature::cosim {

inline constexpr double kShortestInterval_s = 0.001;

// Fills kind and points. Throws InputError with all problems of the file `name`, each with line and column.
void parse_stream(std::string_view text, const std::string& name, std::size_t joints, StreamSpec& stream);

}  // namespace armature::cosim
