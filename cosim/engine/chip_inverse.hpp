// The inverse kinematics of an arm by the block ik_cordic of a chip of its own, through its bus.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "controller/base/units.hpp"
#include "controller/kinematics/inverse_solver.hpp"
#include "controller/robot/robot_model.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim {

// A five-axis pose is projected by software first, as the block requires.
class ChipInverse final : public InverseSolver {
 public:
  // The robot must have an arm (not kNone), and outlive this.
  ChipInverse(const RobotModel& robot, std::unique_ptr<Soc> soc);

  // All branches of the block, in the order of IkSolutions. Where it has none, the reason is that of the software.
  [[nodiscard]] RawSolutions inverse(const Transform& base_T_flange, const Theta& previous) noexcept override;
  // In software: the block has no part in them.
  [[nodiscard]] RawTracking track(const Transform& base_T_flange, const Theta& previous, double wrist_zone,
                                  bool keep_elbow) noexcept override;
  [[nodiscard]] RawTracking track_point(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& flange_p_mm,
                                        const Theta& previous) noexcept override;

  // Of the last inverse(); 0: it did not reach the block.
  [[nodiscard]] std::uint32_t block_clocks() const { return block_clocks_; }
  // From the first write of the pose to the last angle: the block and all accesses of the bus.
  [[nodiscard]] Cycles clocks() const { return clocks_; }

 private:
  const RobotModel& robot_;
  std::unique_ptr<Soc> soc_;
  std::uint32_t block_clocks_ = 0;
  Cycles clocks_{};
};

}  // namespace armature::cosim
