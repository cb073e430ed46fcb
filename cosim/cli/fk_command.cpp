#include <fmt/format.h>

#include <iterator>

#include "cosim/cli/commands.hpp"
#include "cosim/cli/kinematics_command.hpp"
#include "cosim/poses/pose_files.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

std::string describe_pose(const ArmOfFile& robot, const PerAxis<double>& joints_deg) {
  const JointAngles joints = to_radians(joints_deg);
  const Transform pose = robot.arm.forward(joints);
  const RollPitchYaw rpy = rpy_from_rotation(pose.rotation);
  const Manipulability away = robot.arm.manipulability(joints);

  std::string text;
  const auto line = [&text](std::string_view label, const std::string& values) {
    fmt::format_to(std::back_inserter(text), "  {:<20}{}\n", label, values);
  };
  const auto triple = [](double a, double b, double c, int digits) {
    return table_number(a, digits, 14) + table_number(b, digits, 14) + table_number(c, digits, 14);
  };
  text += "flange of " + printable(robot.spec.name) + " in its base\n";
  line("position mm", triple(pose.position_mm.x(), pose.position_mm.y(), pose.position_mm.z(), 6));
  for (int row = 0; row < 3; ++row) {
    line(row == 0 ? "rotation" : "", triple(pose.rotation(row, 0), pose.rotation(row, 1), pose.rotation(row, 2), 9));
  }
  line("roll pitch yaw deg",
       triple(rpy.roll_rad * kDegPerRad, rpy.pitch_rad * kDegPerRad, rpy.yaw_rad * kDegPerRad, 6));
  // 0: there, 1: as far as possible.
  std::string factors = fmt::format("shoulder {:.6f}, elbow {:.6f}", away.shoulder, away.elbow);
  if (robot.model.arm.family == ArmFamily::kSixR) factors += fmt::format(", wrist {:.6f}", away.wrist);
  line("from singularity", factors + " (0 there, 1 farthest)");
  for (std::size_t i = 0; i < robot.spec.axis_count; ++i) {
    const AxisSpec& axis = robot.spec.axes[i];
    if (joints_deg[i] >= axis.min_deg && joints_deg[i] <= axis.max_deg) continue;
    line("outside limits", fmt::format("joint {} at {} deg, not in {} .. {}", i + 1, number_text(joints_deg[i]),
                                       number_text(axis.min_deg), number_text(axis.max_deg)));
  }
  return text;
}

}  // namespace

int fk_command(const FkArguments& arguments, const SearchPath& path) {
  const ArmOfFile robot = load_arm(arguments.robot, path);
  const std::size_t joints = robot.spec.axis_count;
  if (!arguments.in) {
    write_output("-",
                 describe_pose(robot, parse_arguments("joint angles (deg)", arguments.joints, joints, kMostJointDeg)));
    return kExitOk;
  }
  require_output(arguments.out, *arguments.in, robot);
  const TextInput input = read_input(*arguments.in);
  std::vector<Transform> poses;
  for (const PerAxis<double>& row : parse_joints(input.text, input.name, joints)) {
    poses.push_back(robot.arm.forward(to_radians(row)));
  }
  write_output(arguments.out, poses_text(poses));
  return kExitOk;
}

}  // namespace armature::cosim
