#include "cosim/report/format/json/arm_json.hpp"

#include <cstddef>
#include <vector>

#include "cosim/report/measure/path_error.hpp"
#include "cosim/robot/dh_rows.hpp"

namespace armature::cosim {
namespace {

Json links_json(const KinematicsSpec& arm) {
  Json links = Json::array();
  const std::vector<DhRow> rows = dh_rows(arm);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    links.push_back({{"alpha_deg", 90.0 * rows[i].alpha_quarters},
                     {"a_mm", rows[i].a_mm},
                     {"d_mm", rows[i].d_mm},
                     {"sign", arm.sign[i]},
                     {"offset_deg", arm.offset_deg[i]}});
  }
  return links;
}

}  // namespace

Json arm_json(const RobotSpec& robot, const PoseSpec& tool) {
  Json axes = Json::array();
  for (std::size_t i = 0; i < robot.axis_count; ++i) {
    const AxisSpec& axis = robot.axes[i];
    axes.push_back({{"min_deg", axis.min_deg},
                    {"max_deg", axis.max_deg},
                    {"max_speed_deg_s", axis.max_speed_deg_s},
                    {"max_accel_deg_s2", axis.max_accel_deg_s2},
                    {"max_jerk_deg_s3", axis.max_jerk_deg_s3 ? Json(*axis.max_jerk_deg_s3) : Json(nullptr)},
                    {"following_error_deg", axis.following_error_deg}});
  }
  const bool known = robot.kinematics.has_value();
  Json arm = {{"axes", std::move(axes)},
              {"memory_ticks", memory_ticks(robot)},
              {"links", known ? links_json(*robot.kinematics) : Json(nullptr)},
              {"tool", known ? Json{{"xyz_mm", tool.xyz_mm}, {"rpy_deg", tool.rpy_deg}} : Json(nullptr)}};
  if (!robot.mesh_files.empty()) arm["meshes"] = {{"base", robot.meshes.base}, {"links", robot.meshes.links}};
  return arm;
}

Json frames_json(const std::vector<FrameSpec>& frames) {
  Json array = Json::array();
  for (const FrameSpec& frame : frames) {
    array.push_back({{"name", frame.name}, {"xyz_mm", frame.pose.xyz_mm}, {"rpy_deg", frame.pose.rpy_deg}});
  }
  return array;
}

}  // namespace armature::cosim
