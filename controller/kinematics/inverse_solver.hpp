// Solves the closed forms of an arm elsewhere than in software, as in a block of the logic behind the bus of a core.
//
// Arm asks it for every inverse kinematics, and adds limits, whole turns and the choice of the branch. An answer must
// be that of SixR or FiveR for the arm's geometry. A solver belongs to one core, so it may wait for the bus of that.
#pragma once

#include <Eigen/Core>

#include "controller/kinematics/raw_solutions.hpp"
#include "controller/kinematics/transform.hpp"

namespace armature {

class InverseSolver {
 public:
  // The samples of a path, one by one. `wrist_zone` and `keep_elbow` are those of SixR::track(); kFiveR has none.
  [[nodiscard]] virtual RawTracking track(const Transform& base_T_flange, const Theta& previous, double wrist_zone,
                                          bool keep_elbow) noexcept = 0;
  // As SixR::track_point(); kSixR only.
  [[nodiscard]] virtual RawTracking track_point(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& flange_p_mm,
                                                const Theta& previous) noexcept = 0;
  // All branches, for moves to a pose.
  [[nodiscard]] virtual RawSolutions inverse(const Transform& base_T_flange, const Theta& previous) noexcept = 0;

 protected:
  ~InverseSolver() = default;  // never owned through this interface
};

}  // namespace armature
