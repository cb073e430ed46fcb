// Mechanics of axes that do not act on each other: each motor with its inertia under its own position loop.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "controller/base/axes.hpp"
#include "cosim/plant/mechanics.hpp"
#include "cosim/plant/position_loop.hpp"
#include "cosim/plant/position_loops.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

class IndependentAxes final : public Mechanics {
 public:
  // Throws std::invalid_argument when a motor cannot be built.
  explicit IndependentAxes(const RobotSpec& robot);

  std::uint8_t step(std::uint8_t axes, const MotorDemands& demands, Shafts& shafts) override;
  [[nodiscard]] const PositionLoops* loops() const override { return blocked_ == 0 ? &loops_ : nullptr; }
  void block(std::size_t axis, bool on) override { set_bit(blocked_, axis, on); }

 private:
  // Makes a step of every axis that is within its limits. Returns the others, one bit each.
  [[nodiscard]] std::uint8_t step_within_limits(Shafts& shafts) const;
  void step_alone(std::size_t axis, bool controlled, Shafts& shafts) const;

  std::uint8_t blocked_ = 0;          // one bit per axis
  std::vector<PositionLoop> motors_;  // kAxes
  PositionLoops loops_;
};

}  // namespace armature::cosim
