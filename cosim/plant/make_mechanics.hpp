// Creates the mechanics of a robot. Only make_mechanics.cpp knows all implementations.
#pragma once

#include <memory>

#include "cosim/plant/mechanics.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

// Throws std::invalid_argument when a motor cannot be built.
[[nodiscard]] std::unique_ptr<Mechanics> make_mechanics(const RobotSpec& robot);

}  // namespace armature::cosim
