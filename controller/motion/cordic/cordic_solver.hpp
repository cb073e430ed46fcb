// The samples of a path, solved by the block ik_cordic and checked by software.
//
// Software solves each pose as well: its result selects the branch, and is the joint angles where the block states no
// error: near a singularity (kLeastSine), and where the wrist keeps theta_4. A difference above the stated error
// (rtl/ik_cordic/README.md) is kept in check(), and the joint angles are then those of the software.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

#include "controller/base/axes.hpp"
#include "controller/drivers/ik_cordic.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/kinematics/five_r.hpp"
#include "controller/kinematics/fixed/fixed_point.hpp"
#include "controller/kinematics/inverse_solver.hpp"
#include "controller/kinematics/six_r.hpp"
#include "controller/motion/cordic/inverse_check.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class CordicSolver final : public InverseSolver {
 public:
  // Least of each value of Manipulability for which the angles of the block are used.
  static constexpr double kLeastSine = 0.05;

  // The robot must have an arm (not kNone). `bus`: of the core that asks.
  CordicSolver(RegisterBus& bus, const RobotModel& robot) noexcept;

  // Writes the geometry, if the block is present and the one that this software supports (`usable` of check()).
  void start() noexcept;

  // InverseSolver
  [[nodiscard]] RawTracking track(const Transform& base_T_flange, const Theta& previous, double wrist_zone,
                                  bool keep_elbow) noexcept override;
  [[nodiscard]] RawTracking track_point(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& flange_p_mm,
                                        const Theta& previous) noexcept override;
  [[nodiscard]] RawSolutions inverse(const Transform& base_T_flange, const Theta& previous) noexcept override;

  [[nodiscard]] InverseCheck& check() noexcept { return check_; }

 private:
  [[nodiscard]] RawTracking track_in_software(const Transform& base_T_flange, const Theta& previous, double wrist_zone,
                                              bool keep_elbow) const noexcept;
  [[nodiscard]] static std::size_t branch_of(const RawSides& sides) noexcept;
  [[nodiscard]] bool is_regular(const Theta& theta, const RawSides& sides) const noexcept;
  void write(const FixedPose& pose) noexcept;
  [[nodiscard]] bool start(const Transform& base_T_flange) noexcept;
  [[nodiscard]] bool wait() noexcept;
  void use_block(RawTracking& found) noexcept;
  [[nodiscard]] bool agrees(const Theta& block, const Theta& software, const RawSides& sides) noexcept;

  RegisterBus& bus_;
  IkCordic block_;
  FixedArm arm_;
  std::variant<SixR, FiveR> family_;
  PerAxis<double> rad_per_pulse_;
  std::optional<FixedPose> written_;  // what the registers of the pose contain
  InverseCheck check_;
};

}  // namespace armature
