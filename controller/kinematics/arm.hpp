// The kinematics of the robot's arm, whatever its family: the one door for planners, files and the command line.
//
// Poses are those of the flange in the base frame of the Denavit-Hartenberg model, in mm; joint angles are the
// vendor's. Vo 2021 eq. (24)-(45) and Hu 2012 eq. (1)-(15), corrected; six_r.hpp and five_r.hpp say where the prints
// are wrong. No heap, no exceptions; const, so both cores may use one object.
#pragma once

#include <Eigen/Core>
#include <variant>

#include "controller/kinematics/branch_choice.hpp"
#include "controller/kinematics/five_r.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/jacobian.hpp"
#include "controller/kinematics/raw_solutions.hpp"
#include "controller/kinematics/six_r.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class Arm {
 public:
  // The limits of every axis must be min <= max, its speed > 0. Of an arm without a geometry (kNone) only known() means
  // anything: forward() is the identity, inverse() and track() are kInvalidInput, jacobian() is 0.
  explicit Arm(const RobotModel& robot) noexcept;

  [[nodiscard]] bool known() const noexcept { return family_.index() != 0; }

  // base_T_flange. Joints within kLargestTheta_rad; not finite far beyond.
  [[nodiscard]] Transform forward(const JointAngles& joints) const noexcept;

  // All branches, and the choice between them: the one whose joint move from `previous` is the shortest in time, with
  // the 360-degree turns of each joint that are inside its limits nearest to `previous` (branch_choice.hpp). For joint
  // moves, where flags may change freely.
  [[nodiscard]] IkSolutions inverse(const Transform& base_T_flange, const JointAngles& previous) const noexcept;

  // The branch nearest to `previous`, joint by joint and turn by turn, without the search: for samples of a path that
  // follow each other closely. It never looks for another turn or another shoulder: where the nearest has a joint
  // outside its limits the answer is kOutsideLimits, where it cannot reach kUnreachable. Crossing theta_5 = 0 keeps
  // theta_4 and theta_6. Around the wrist singularity (|sin theta_5| < 1e-7, 1e-7 rad of orientation, a hundredth of a
  // pulse) theta_4 is kept as in a singular pose, because its rounding noise would otherwise exceed acceleration
  // limits. kSingular tells. Steps are not limited here: near a singularity the nearest branch may still be far. Where
  // `previous` is stretched or folded both elbows are as near: the one whose joints are inside their limits is taken.
  [[nodiscard]] IkTracking track(const Transform& base_T_flange, const JointAngles& previous) const noexcept;

  // track() with theta_4 of `previous` kept, whatever the orientation: the pose is met but for a rotation by the angle
  // between the approach and the plane that theta_4 leaves to it. For the passage of the wrist singularity, kSixR only
  // (otherwise track()).
  [[nodiscard]] IkTracking track_keeping_theta4(const Transform& base_T_flange,
                                                const JointAngles& previous) const noexcept;

  // sin(theta_5), whose sign says on which side of the wrist singularity the arm is. 1 for what is not kSixR.
  [[nodiscard]] double wrist_sine(const JointAngles& joints) const noexcept;

  [[nodiscard]] Jacobian jacobian(const JointAngles& joints) const noexcept;
  [[nodiscard]] Manipulability manipulability(const JointAngles& joints) const noexcept;

  // Joint rates (rad/s, vendor's convention) for a flange velocity v (mm/s) and w (rad/s) in closed form; kSixR only,
  // otherwise 0. Not finite at a singularity: ask manipulability() first.
  [[nodiscard]] PerAxis<double> joint_rates(const JointAngles& joints, const Eigen::Vector3d& v_mm_s,
                                            const Eigen::Vector3d& w_rad_s) const noexcept;

 private:
  [[nodiscard]] IkTracking within_limits(const RawTracking& raw) const noexcept;
  // What `ask` answers for the family of this arm; `none` without a geometry.
  template <class Result, class Ask>
  [[nodiscard]] Result ask_family(Result none, Ask ask) const noexcept;
  // Between the vendor's joint angles and theta, in the order sign * q + offset.
  [[nodiscard]] Theta to_theta(const JointAngles& joints) const noexcept;
  [[nodiscard]] JointAngles to_joints(const Theta& theta) const noexcept;

  ArmGeometry geometry_;
  PerAxis<JointRange> ranges_;
  std::variant<std::monostate, SixR, FiveR> family_;  // monostate: kNone
};

}  // namespace armature
