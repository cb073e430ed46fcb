// The kinematics of the robot's arm, for both families: the one interface for planners, files and the command line.
//
// Poses are those of the flange in the base frame of the Denavit-Hartenberg model, in mm; joint angles are the
// vendor's. Vo 2021 eq. (24)-(45) and Hu 2012 eq. (1)-(15), corrected; six_r.hpp and five_r.hpp say where the prints
// are wrong. No heap, no exceptions. Its functions are const, so both cores may use one object without a solver.
#pragma once

#include <Eigen/Core>
#include <variant>

#include "controller/kinematics/branch_choice.hpp"
#include "controller/kinematics/configuration.hpp"
#include "controller/kinematics/five_r.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/inverse_solver.hpp"
#include "controller/kinematics/jacobian.hpp"
#include "controller/kinematics/raw_solutions.hpp"
#include "controller/kinematics/six_r.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class Arm {
 public:
  // The limits of every axis must be min <= max, its speed > 0. For an arm without a geometry (kNone) only known() has
  // a meaning: forward() returns the identity, inverse() and track() return kInvalidInput, jacobian() returns 0.
  explicit Arm(const RobotModel& robot) noexcept;

  // From now on `solver` solves the closed forms of inverse(), soonest() and the track functions; null: software does.
  // It must outlive the arm or be taken back.
  void solve_with(InverseSolver* solver) noexcept { solver_ = solver; }

  [[nodiscard]] bool known() const noexcept { return family_.index() != 0; }

  // base_T_flange. Joints within kLargestTheta_rad; the result is not finite far beyond.
  [[nodiscard]] Transform forward(const JointAngles& joints) const noexcept;

  // All branches, and the selected one: its joint move from `previous` takes the shortest time. Each joint has the
  // number of 360-degree turns that is inside its limits and nearest to `previous` (branch_choice.hpp). For joint
  // moves, which may change the branch. With a configuration the result contains only the branches with the requested
  // sides, and each joint has the requested turns (otherwise it is outside its limits).
  [[nodiscard]] IkSolutions inverse(const Transform& base_T_flange, const JointAngles& previous,
                                    const Configuration& wanted = {}) const noexcept;

  // The selected branch of inverse() alone, bit for bit, with its status: in software in less than half the time,
  // because the wrists of arms whose joints 1 to 3 already take longer than another branch are not computed. `found`
  // when it is solved.
  [[nodiscard]] IkTracking soonest(const Transform& base_T_flange, const JointAngles& previous,
                                   const Configuration& wanted = {}) const noexcept;

  // The branch nearest to `previous`, joint by joint and turn by turn, without a search: for closely spaced samples of
  // a path. It never changes the turn or the shoulder: the status is kOutsideLimits when a joint of the nearest
  // solution is outside its limits, and kUnreachable when this branch does not reach the pose. theta_4 and theta_6
  // are kept when the path crosses theta_5 = 0. Near the wrist singularity (|sin theta_5| < 1e-7, 1e-7 rad of
  // orientation, a hundredth of a pulse) theta_4 is kept as in a singular pose, because its rounding noise would
  // otherwise exceed acceleration limits; the status is then kSingular. The size of a step is not limited here: near a
  // singularity the nearest branch may still be far. If `previous` is stretched or folded, both elbows are equally
  // near; the one whose joints are inside their limits is selected.
  [[nodiscard]] IkTracking track(const Transform& base_T_flange, const JointAngles& previous) const noexcept;

  // As track(), but never the elbow whose joints 2 and 3 are farther from `previous`. For samples of a path that are so
  // far apart that the wrist may turn by a quarter turn between them.
  [[nodiscard]] IkTracking track_keeping_elbow(const Transform& base_T_flange,
                                               const JointAngles& previous) const noexcept;

  // As track(), but theta_4 is that of `previous` for any orientation. The pose is met except for a rotation by the
  // angle between the approach and the plane that theta_4 leaves for it. For the passage of the wrist singularity;
  // kSixR only (otherwise as track()).
  [[nodiscard]] IkTracking track_keeping_theta4(const Transform& base_T_flange,
                                                const JointAngles& previous) const noexcept;

  // Joints 1 to 3 that bring `flange_p_mm`, a point in the frame of the flange, to `point_mm` in the base, nearest to
  // `previous` and without a jump; joints 4 to 6 are those of `previous`. For a passage of the wrist singularity on
  // which only the orientation may differ; kSixR only, otherwise kInvalidInput.
  [[nodiscard]] IkTracking track_point(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& flange_p_mm,
                                       const JointAngles& previous) const noexcept;

  // x and y of the approach of the hand in the frame of the forearm: sin(theta_5) times cosine and sine of theta_4.
  // (1, 0) if not kSixR. Along a path it is smooth, also through the wrist singularity (0, 0).
  [[nodiscard]] Eigen::Vector2d approach_in_forearm(const JointAngles& joints) const noexcept;

  // sin(theta_5): its sign gives the side of the wrist singularity on which the arm is. 1 if not kSixR.
  [[nodiscard]] double wrist_sine(const JointAngles& joints) const noexcept;

  // The configuration of the arm, with turns. A side is kNearest at its singularity: closer to it than Undecided says.
  struct Undecided {
    static constexpr double kShoulder = 1e-9, kElbow = 5e-5, kWrist = 1e-7;  // of Manipulability
  };
  [[nodiscard]] Configuration configuration(const JointAngles& joints) const noexcept;
  // The sides that the flags of a branch stand for; without turns.
  [[nodiscard]] static Configuration configuration(const IkBranch& branch) noexcept;

  [[nodiscard]] Jacobian jacobian(const JointAngles& joints) const noexcept;
  [[nodiscard]] Manipulability manipulability(const JointAngles& joints) const noexcept;

  // The singularity with the smallest indicator, if that is below `near`; otherwise kNotSingular.
  [[nodiscard]] Singularity nearest_singularity(const JointAngles& joints, double near) const noexcept;

  // Joint rates (rad/s, vendor's convention) for a flange velocity v (mm/s) and w (rad/s) in closed form; kSixR only,
  // otherwise 0. Not finite at a singularity: check manipulability() first.
  [[nodiscard]] PerAxis<double> joint_rates(const JointAngles& joints, const Eigen::Vector3d& v_mm_s,
                                            const Eigen::Vector3d& w_rad_s) const noexcept;
  // forward() and joint_rates() of several velocities at one position. Only of an arm with 6R: of others the posture is
  // empty, the flange the identity and the rates are 0.
  [[nodiscard]] SixRPosture posture(const JointAngles& joints) const noexcept;
  [[nodiscard]] Transform flange_at(const SixRPosture& posture) const noexcept;
  [[nodiscard]] PerAxis<double> joint_rates(const SixRPosture& posture, const Eigen::Vector3d& v_mm_s,
                                            const Eigen::Vector3d& w_rad_s) const noexcept;

 private:
  [[nodiscard]] IkTracking soonest_of(const SixR& six_r, const Transform& base_T_flange,
                                      const JointAngles& previous) const noexcept;
  [[nodiscard]] IkTracking track(const Transform& base_T_flange, const Theta& previous, double wrist_zone,
                                 bool keep_elbow = false) const noexcept;
  [[nodiscard]] IkTracking within_limits(const RawTracking& raw) const noexcept;
  [[nodiscard]] PerAxis<JointRange> ranges_with(const Turns& turns) const noexcept;
  // The result of `call` for the family of this arm; that of `none` without a geometry.
  template <class None, class Call>
  [[nodiscard]] auto dispatch(None none, Call call) const noexcept;
  // Conversion between the vendor's joint angles and theta = sign * q + offset.
  [[nodiscard]] Theta to_theta(const JointAngles& joints) const noexcept;
  [[nodiscard]] JointAngles to_joints(const Theta& theta) const noexcept;

  ArmGeometry geometry_;
  PerAxis<JointRange> ranges_;
  std::variant<std::monostate, SixR, FiveR> family_;  // monostate: kNone
  InverseSolver* solver_ = nullptr;
};

}  // namespace armature
