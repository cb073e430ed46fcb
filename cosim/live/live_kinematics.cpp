#include "cosim/live/live_kinematics.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "controller/base/angle_units.hpp"
#include "controller/robot/robot_model.hpp"
#include "cosim/poses/pose_files.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr double kOnAxis_mm = 1e-6;  // nearer to axis 1 the plane of the arm is not known

Json array(const Eigen::Vector3d& values) {
  return Json::array({values.x(), values.y(), values.z()});
}

Transform turned_about_z(const Transform& pose, double rad) {
  return Transform{rotation_from_rpy(0, 0, rad), Eigen::Vector3d::Zero()} * pose;
}

// At a singularity both sides are one.
template <class Side>
std::string_view side(Side of_branch) {
  return of_branch == Side::kNearest ? "either" : word_of(of_branch);
}

Json branch_json(const IkBranch& branch, const RobotSpec& robot, bool flips) {
  const Configuration sides = Arm::configuration(branch);
  Json joints = Json::array();
  for (std::size_t i = 0; i < robot.axis_count; ++i) joints.push_back(branch.joints[i].value() * kDegPerRad);
  Json json = {{"joints_deg", std::move(joints)},
               {"shoulder", side(sides.shoulder)},
               {"elbow", side(sides.elbow)},
               {"wrist", flips ? Json(side(sides.wrist)) : Json(nullptr)},
               {"within_limits", branch.within_limits},
               {"why_not", nullptr}};
  if (!branch.within_limits) {
    const AxisSpec& axis = robot.axes.at(branch.outside_axis - 1u);
    json["why_not"] = fmt::format("joint {} would leave its range {} .. {} deg", branch.outside_axis,
                                  number_text(axis.min_deg), number_text(axis.max_deg));
  }
  return json;
}

}  // namespace

LiveKinematics::LiveKinematics(const Scenario& scenario)
    : robot_{scenario.robot},
      arm_{to_robot_model(scenario.robot)},
      flange_T_tool_{to_transform(scenario.tool)},
      five_axes_{scenario.robot.kinematics && scenario.robot.kinematics->family == kFiveRFamily} {}

Json LiveKinematics::forward(const JointAngles& joints) const {
  const Transform tool = arm_.forward(joints) * flange_T_tool_;
  const RollPitchYaw rpy = rpy_from_rotation(tool.rotation);
  return {{"xyz_mm", array(tool.position_mm)},
          {"rpy_deg", array(Eigen::Vector3d{rpy.roll_rad, rpy.pitch_rad, rpy.yaw_rad} * kDegPerRad)}};
}

Transform LiveKinematics::base_T_tool(const Wish& wish) const {
  if (wish.rpy_deg) {
    const Eigen::Vector3d rpy = *wish.rpy_deg * kRadPerDeg;
    return {rotation_from_rpy(rpy.x(), rpy.y(), rpy.z()), wish.xyz_mm};
  }
  Transform pose = arm_.forward(wish.from) * flange_T_tool_;
  if (five_axes_) {
    const Eigen::Vector2d before = pose.position_mm.head<2>();
    const Eigen::Vector2d after = wish.xyz_mm.head<2>();
    if (before.norm() > kOnAxis_mm && after.norm() > kOnAxis_mm) {
      pose = turned_about_z(pose, std::atan2(after.y(), after.x()) - std::atan2(before.y(), before.x()));
    }
  }
  pose.position_mm = wish.xyz_mm;
  return pose;
}

Json LiveKinematics::inverse(const Wish& wish) const {
  const IkSolutions solutions = arm_.inverse(base_T_tool(wish) * armature::inverse(flange_T_tool_), wish.from);
  Json branches = Json::array();
  for (std::size_t i = 0; i < solutions.count; ++i) {
    branches.push_back(branch_json(solutions.branches[i], robot_, !five_axes_));
  }
  const bool met = solutions.selected >= 0;
  return {{"solutions", std::move(branches)},
          {"selected", met ? Json(solutions.selected) : Json(nullptr)},
          {"why_not", met ? Json(nullptr) : Json(why_not(solutions))}};
}

std::string LiveKinematics::why_not(const IkSolutions& solutions) const {
  switch (solutions.status) {
    case IkStatus::kUnreachable:
      return fmt::format("out of reach by {:.1f} mm: the wrist would be too far from the shoulder, or too near to it",
                         solutions.margin_mm);
    case IkStatus::kOutsideLimits: {
      const AxisSpec& axis = robot_.axes.at(solutions.axis - 1u);
      return fmt::format("joint {} would have to be at {:.1f} deg, outside of its range {} .. {} deg", solutions.axis,
                         solutions.angle_rad * kDegPerRad, number_text(axis.min_deg), number_text(axis.max_deg));
    }
    case IkStatus::kOrientation:
      return fmt::format("five joints cannot give the hand this orientation: it is {:.2f} deg off",
                         solutions.residual_rad * kDegPerRad);
    default:
      return no_solution_text(solutions);
  }
}

}  // namespace armature::cosim
