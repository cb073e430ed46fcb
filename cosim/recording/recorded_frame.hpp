// The frames of a run, read from the summary.
#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "controller/kinematics/transform.hpp"

namespace armature::cosim {

// Of `xyz_mm` and `rpy_deg`, as the summary has them.
[[nodiscard]] Transform recorded_pose(const nlohmann::ordered_json& pose);
[[nodiscard]] Eigen::Isometry3d isometry_of(const Transform& pose);

struct RecordedFrame {
  std::string name;  // "base", or that of a [[frame]]
  Transform base_T_frame{};
};

// Those of the scenario. None if an older version wrote the summary.
[[nodiscard]] std::vector<RecordedFrame> recorded_frames(const nlohmann::ordered_json& summary);

// Nothing if the run has no program with positions, or if an older version wrote the summary.
[[nodiscard]] std::optional<RecordedFrame> recorded_program_frame(const nlohmann::ordered_json& summary);

}  // namespace armature::cosim
