// Mechanics of axes that do not act on each other: each motor with its inertia under its own position loop.
#pragma once

#include <vector>

#include "cosim/plant/mechanics.hpp"
#include "cosim/plant/position_loop.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

class IndependentAxes final : public Mechanics {
 public:
  // Throws std::invalid_argument when a motor cannot be built.
  explicit IndependentAxes(const RobotSpec& robot);

  std::uint8_t step(std::uint8_t axes, const PerAxis<MotorDemand>& demands, PerAxis<Shaft>& shafts) override;

 private:
  std::vector<PositionLoop> motors_;  // kAxes
};

}  // namespace armature::cosim
