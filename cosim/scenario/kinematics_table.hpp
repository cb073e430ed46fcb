// The table [kinematics] of a robot file.
#pragma once

#include "cosim/scenario/robot_spec.hpp"
#include "cosim/scenario/table_reader.hpp"

namespace armature::cosim {

// Reads and checks the table. Without a family that is known, only that is reported, and `family` stays empty.
void read_kinematics(TableReader& table, KinematicsSpec& kinematics);

}  // namespace armature::cosim
