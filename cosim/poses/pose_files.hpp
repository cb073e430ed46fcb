// The files of `armature fk` and `armature ik`: joints, poses, solutions. Angles in degrees in the vendor's convention,
// positions in mm, poses as rows of the 3x4 matrix [R | p] of the flange in the base. Numbers are written with the
// digits that read back as the same double, at most 17.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/transform.hpp"

namespace armature::cosim {

inline constexpr double kMaxJointDeg = 36'000;  // a hundred turns, as for the limits in robot files
inline constexpr double kMaxPositionMm = 1e9;
inline constexpr double kRotationTolerance = 1e-6;  // that of is_rigid()

// Why this is not a rotation matrix (is_rigid() in transform.hpp: orthonormal within a millionth, determinant +1).
// Nullopt if it is one.
[[nodiscard]] std::optional<std::string> rotation_problem(const Eigen::Matrix3d& rotation);

struct PoseRow {
  Transform pose;
  PerAxis<double> previous_deg{};  // 0 where the file has no previous joints
};

// `j1_deg,...`: as many columns as the arm has joints. Throws InputError, as number_csv.hpp says.
[[nodiscard]] std::vector<PerAxis<double>> parse_joints(std::string_view text, const std::string& name,
                                                        std::size_t joints);
// `t11,t12,t13,t14,t21,...,t34`, and then nothing or `prev1_deg,...` for every joint.
[[nodiscard]] std::vector<PoseRow> parse_poses(std::string_view text, const std::string& name, std::size_t joints);

[[nodiscard]] std::string poses_text(std::span<const Transform> poses);

// `unreachable by 12.345678 mm`, `orientation off by 1.230000 deg`: why there is no solution. Without a comma.
[[nodiscard]] std::string no_solution_text(const IkSolutions& solutions);

// `pose,branch,shoulder,elbow,flip,singular,within_limits,selected,j1_deg,...` and one row for each branch. A pose
// without a branch has the row `pose,none,REASON` with the other fields empty.
class SolutionsText {
 public:
  explicit SolutionsText(std::size_t joints);
  void add(const IkSolutions& solutions);  // of the next pose
  [[nodiscard]] const std::string& text() const noexcept { return text_; }

 private:
  void add_branch(std::size_t branch, const IkSolutions& solutions);

  std::size_t joints_;
  std::size_t poses_ = 0;
  std::string text_;
};

}  // namespace armature::cosim
