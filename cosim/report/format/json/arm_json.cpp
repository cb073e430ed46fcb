#include "cosim/report/format/json/arm_json.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include "cosim/report/measure/path_error.hpp"

namespace armature::cosim {
namespace {

// Denavit-Hartenberg parameters of a link; controller/robot/arm_geometry.hpp names the tables of the papers.
struct LinkShape {
  double alpha_deg = 0, a_mm = 0, d_mm = 0;
};

std::vector<LinkShape> link_shapes(const KinematicsSpec& arm) {
  if (arm.family == kFiveRFamily) {
    return {{-90, arm.a1_mm, 0}, {0, arm.a2_mm, 0}, {0, arm.a3_mm, 0}, {-90, arm.a4_mm, 0}, {0, 0, arm.d5_mm}};
  }
  return {{90, arm.a1_mm, arm.d1_mm}, {0, arm.a2_mm, 0}, {90, arm.a3_mm, 0},
          {-90, 0, arm.d4_mm},        {90, 0, 0},        {0, 0, arm.d6_mm}};
}

Json links_json(const KinematicsSpec& arm) {
  Json links = Json::array();
  const std::vector<LinkShape> shapes = link_shapes(arm);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    links.push_back({{"alpha_deg", shapes[i].alpha_deg},
                     {"a_mm", shapes[i].a_mm},
                     {"d_mm", shapes[i].d_mm},
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
  return {{"axes", std::move(axes)},
          {"memory_ticks", memory_ticks(robot)},
          {"links", known ? links_json(*robot.kinematics) : Json(nullptr)},
          {"tool", known ? Json{{"xyz_mm", tool.xyz_mm}, {"rpy_deg", tool.rpy_deg}} : Json(nullptr)}};
}

}  // namespace armature::cosim
