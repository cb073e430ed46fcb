// The links of the arm of a run, read from the summary: forward kinematics for what shows a run.
#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

namespace armature::cosim {

class RecordedArm {
 public:
  // Nothing if the robot has no kinematics. `summary`: summary.json.
  [[nodiscard]] static std::optional<RecordedArm> of(const nlohmann::ordered_json& summary);

  [[nodiscard]] std::size_t joints() const { return links_.size(); }
  // From the frame before the joint to the one behind the link [mm], at this angle of the joint.
  [[nodiscard]] Eigen::Isometry3d link(std::size_t joint, double angle_deg) const;
  // The tool centre point in the flange, which is the last of these frames [mm].
  [[nodiscard]] const Eigen::Isometry3d& flange_T_tool() const { return flange_T_tool_; }
  // The tool centre point in the base [mm]. `angles_deg`: one of each joint.
  [[nodiscard]] Eigen::Isometry3d tool(std::span<const double> angles_deg) const;

 private:
  struct Link {
    double sign = 1, offset_deg = 0;
    Eigen::Isometry3d end;  // seen from the turned joint
  };

  std::vector<Link> links_;
  Eigen::Isometry3d flange_T_tool_ = Eigen::Isometry3d::Identity();
};

}  // namespace armature::cosim
