// The kinematics of the robot's arm, whatever its family: the one door for planners, files and the command line.
//
// Poses are those of the flange in the base frame of the Denavit-Hartenberg model, in mm; joint angles are the
// vendor's. Vo 2021 eq. (24)-(45) and Hu 2012 eq. (1)-(15), corrected; six_r.hpp and five_r.hpp say where the prints
// are wrong. No heap, no exceptions; const, so both cores may use one object.
#pragma once

#include <Eigen/Core>

#include "controller/kinematics/five_r.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/six_r.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

// Rows v (mm/rad) then w (rad/rad), a column a joint, in the vendor's convention. Columns beyond the arm's joints are
// 0.
using Jacobian = Eigen::Matrix<double, 6, 6>;

class Arm {
 public:
  // The robot's geometry must not be kNone for anything but known().
  explicit Arm(const RobotModel& robot) noexcept;

  [[nodiscard]] bool known() const noexcept { return robot_.arm.family != ArmFamily::kNone; }

  // base_T_flange.
  [[nodiscard]] Transform forward(const JointAngles& joints) const noexcept;

  // All branches, and the choice between them: the one whose joint move from `previous` is the shortest in time, with
  // the 360-degree turns of each joint that are inside its limits nearest to `previous`.
  [[nodiscard]] IkSolutions inverse(const Transform& base_T_flange, const JointAngles& previous) const noexcept;

  // The branch nearest to `previous`, joint by joint, without the search: for samples of a path that follow each other
  // closely. Crossing theta_5 = 0 keeps theta_4 and theta_6. Around the wrist singularity (|sin theta_5| < 1e-7, 1e-7
  // rad of orientation, a hundredth of a pulse) theta_4 is kept as in a singular pose, because its rounding noise would
  // otherwise exceed acceleration limits. kSingular tells.
  [[nodiscard]] IkTracking track(const Transform& base_T_flange, const JointAngles& previous) const noexcept;

  [[nodiscard]] Jacobian jacobian(const JointAngles& joints) const noexcept;
  [[nodiscard]] Manipulability manipulability(const JointAngles& joints) const noexcept;

  // Joint rates (rad/s, vendor's convention) for a flange velocity v (mm/s) and w (rad/s) in closed form; kSixR only.
  // Not finite at a singularity: ask manipulability() first.
  [[nodiscard]] PerAxis<double> joint_rates(const JointAngles& joints, const Eigen::Vector3d& v_mm_s,
                                            const Eigen::Vector3d& w_rad_s) const noexcept;

 private:
  RobotModel robot_;
  SixR six_r_;
  FiveR five_r_;
};

}  // namespace armature
