#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/kinematics_io.hpp"
#include "cosim/cli/options/output_options.hpp"
#include "cosim/poses/pose_files.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kFkDetails = R"(Examples:
  armature fk --robot abb_irb120 10 20 -30 0 45 90
  armature fk --robot abb_irb120 10 20 -30 0 45 90 --json
  armature fk --robot abb_irb120 10 20 -30 0 45 90 --tool 0 0 120 0 0 0 --frame 300 100 0 0 0 90
  armature fk --robot abb_irb120 --in scenarios/robots/examples/joints.csv --out poses.csv
  printf 'j1_deg,j2_deg,j3_deg,j4_deg,j5_deg\n0,-90,0,-90,0\n' | armature fk --robot hu2012_5r --in -

joints.csv has the header j1_deg,...,j6_deg, with one column for each joint of the arm. poses.csv has the columns
t11,t12,t13,t14,t21,...,t34: the rows of the 3x4 matrix [R | p], with p in mm. Limits are not applied.
Poses are those of the flange in the base. With --tool they are those of the tool, with --frame they are in a user frame.
Both take the six numbers of the keys xyz_mm and rpy_deg of [tool] and [[frame]] in scenarios, and also apply to files.
Exit code: 0 ok, 2 bad input (then nothing is written).)";

struct FkOptions {
  PoseFileOptions files;
  OutputOptions output;
  std::vector<std::string> joints;  // one pose: angles [deg] as written; otherwise empty
};

struct PoseFacts {
  Transform pose;
  RollPitchYaw rpy;
  Manipulability away;  // from the singularities
  Configuration sides;
  std::vector<std::size_t> outside;  // indices of the joints outside of their limits
};

PoseFacts facts_of(const ArmOfFile& robot, const PoseFrames& frames, const PerAxis<double>& joints_deg) {
  const JointAngles joints = to_radians(joints_deg);
  const Transform pose = frames.shown(robot.arm.forward(joints));
  PoseFacts facts{.pose = pose,
                  .rpy = rpy_from_rotation(pose.rotation),
                  .away = robot.arm.manipulability(joints),
                  .sides = robot.arm.configuration(joints),
                  .outside = {}};
  for (std::size_t i = 0; i < robot.spec.axis_count; ++i) {
    const AxisSpec& axis = robot.spec.axes[i];
    if (!(joints_deg[i] >= axis.min_deg && joints_deg[i] <= axis.max_deg)) facts.outside.push_back(i);
  }
  return facts;
}

std::string describe_pose(const ArmOfFile& robot, const PoseFrames& frames, const PerAxis<double>& joints_deg) {
  const auto [pose, rpy, away, sides, outside] = facts_of(robot, frames, joints_deg);

  std::string text;
  const auto line = [&text](std::string_view label, const std::string& values) {
    fmt::format_to(std::back_inserter(text), "  {:<20}{}\n", label, values);
  };
  const auto triple = [](double a, double b, double c, int digits) {
    return table_number(a, digits, 14) + table_number(b, digits, 14) + table_number(c, digits, 14);
  };
  text += frames.point() + " of " + printable(robot.spec.name) + " in " + frames.frame() + "\n";
  line("position mm", triple(pose.position_mm.x(), pose.position_mm.y(), pose.position_mm.z(), 6));
  for (int row = 0; row < 3; ++row) {
    line(row == 0 ? "rotation" : "", triple(pose.rotation(row, 0), pose.rotation(row, 1), pose.rotation(row, 2), 9));
  }
  line("roll pitch yaw deg",
       triple(rpy.roll_rad * kDegPerRad, rpy.pitch_rad * kDegPerRad, rpy.yaw_rad * kDegPerRad, 6));
  // Manipulability factors: 0 at the singularity, 1 at the largest distance.
  std::string factors = fmt::format("shoulder {:.6f}, elbow {:.6f}", away.shoulder, away.elbow);
  if (robot.model.arm.family == ArmFamily::kSixR) factors += fmt::format(", wrist {:.6f}", away.wrist);
  line("from singularity", factors + " (0 there, 1 farthest)");
  line("configuration", configuration_text(sides, robot));
  for (const std::size_t i : outside) {
    const AxisSpec& axis = robot.spec.axes[i];
    line("outside limits", fmt::format("joint {} at {} deg, not in {} .. {}", i + 1, number_text(joints_deg[i]),
                                       number_text(axis.min_deg), number_text(axis.max_deg)));
  }
  return text;
}

nlohmann::ordered_json pose_json(const ArmOfFile& robot, const PoseFrames& frames, const PerAxis<double>& joints_deg) {
  const auto [pose, rpy, away, sides, outside] = facts_of(robot, frames, joints_deg);
  const bool flips = robot.model.arm.family == ArmFamily::kSixR;
  nlohmann::ordered_json rotation = nlohmann::ordered_json::array();
  for (int row = 0; row < 3; ++row) {
    rotation.push_back({pose.rotation(row, 0), pose.rotation(row, 1), pose.rotation(row, 2)});
  }
  nlohmann::ordered_json json = {
      {"robot", robot.spec.name},
      {"position_mm", {pose.position_mm.x(), pose.position_mm.y(), pose.position_mm.z()}},
      {"rotation", std::move(rotation)},
      {"rpy_deg", {rpy.roll_rad * kDegPerRad, rpy.pitch_rad * kDegPerRad, rpy.yaw_rad * kDegPerRad}},
      {"from_singularity", {{"shoulder", away.shoulder}, {"elbow", away.elbow}}},
      {"configuration", {{"shoulder", side_text(sides.shoulder)}, {"elbow", side_text(sides.elbow)}}}};
  if (flips) {
    json["from_singularity"]["wrist"] = away.wrist;
    json["configuration"]["wrist"] = side_text(sides.wrist);
  }
  json["joints_outside_limits"] = nlohmann::ordered_json::array();
  for (const std::size_t i : outside) json["joints_outside_limits"].push_back(i + 1);
  return json;
}

int run(const FkOptions& given, const SearchPath& path) {
  const ArmOfFile robot = load_arm(given.files.robot, path);
  const PoseFrames frames = given.files.frames();
  const std::size_t joints = robot.spec.axis_count;
  if (!given.files.in) {
    const auto joints_deg = parse_arguments("joint angles (deg)", given.joints, joints, kMaxJointDeg);
    if (given.output.json) {
      print_json(pose_json(robot, frames, joints_deg));
    } else {
      write_output("-", describe_pose(robot, frames, joints_deg));
    }
    return kExitOk;
  }
  require_output(given.files.out, *given.files.in, robot);
  const TextInput input = read_input(*given.files.in);
  std::vector<Transform> poses;
  for (const PerAxis<double>& row : parse_joints(input.text, input.name, joints)) {
    poses.push_back(frames.shown(robot.arm.forward(to_radians(row))));
  }
  write_output(given.files.out, poses_text(poses));
  return kExitOk;
}

CommandAction declare_fk(CLI::App& app) {
  const auto options = std::make_shared<FkOptions>();
  add_pose_file_options(app, options->files, "File of joint angles, '-' for standard input",
                        "File for the poses (default '-', standard output)");
  app.add_option("joints", options->joints, "Joint angles of one pose [deg]")->excludes("--in");
  add_json_option(app, options->output);
  app.get_option("--json")->excludes("--in");
  // An option of `ik`. Without this declaration CLI11 would read its numbers as joint angles of a pose.
  app.add_option("--previous")->expected(0, 6)->group("");
  app.callback([options, &app] {
    if (app.count("--previous") > 0) {
      throw CLI::ValidationError("--previous", "belongs to 'armature ik': poses do not depend on the joints before");
    }
    if (!options->files.in && options->joints.empty()) throw CLI::RequiredError("Joint angles or --in");
  });
  return [options](const CommonOptions& common) { return run(*options, common.search_path()); };
}

}  // namespace

Subcommand fk_command() {
  return {.name = "fk",
          .order = 50,
          .summary = "Forward kinematics: poses of the flange or of a tool from joint angles",
          .details = kFkDetails,
          .declare = declare_fk};
}

}  // namespace armature::cosim
