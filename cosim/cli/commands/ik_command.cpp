#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "controller/robot/axis_units.hpp"
#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/kinematics_io.hpp"
#include "cosim/cli/options/output_options.hpp"
#include "cosim/poses/pose_files.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kIkDetails = R"(Examples:
  armature ik --robot abb_irb120 --xyz 350 -120 500 --rpy 30 120 -10
  armature ik --robot abb_irb120 --xyz 350 -120 500 --rpy 30 120 -10 --previous 0 0 0 90 0 -90
  armature ik --robot abb_irb120 --xyz -20 80 500 --rpy 30 120 -10 --tool 0 0 120 0 0 0 --frame 300 -100 0 0 0 90
  armature ik --robot abb_irb120 --xyz 350 -120 500 --rpy 30 120 -10 --json
  armature ik --robot abb_irb120 --in poses.csv --out solutions.csv

poses.csv has the format that 'armature fk' writes. It may have more columns prev1_deg,...: the previous joint angles.
Without them the previous angles are 0.
solutions.csv has one row for each branch, in the order shoulder (1, -1), elbow (1, -1), flip (1, -1):
pose,branch,shoulder,elbow,flip,singular,within_limits,selected,j1_deg,...
flip is 0 for five axes. In the words of the keys of a [[move]]: shoulder 1 is front; elbow 1 is up if shoulder is 1, and
down if it is -1; flip -1 is noflip. singular is a sum: 1 shoulder, 2 wrist, 4 elbow, 8 folded. selected marks the branch within the
limits that a joint move from the previous angles reaches first. A pose without a branch has the row pose,none,REASON.
Poses are those of the flange in the base. With --tool they are those of the tool, with --frame they are in a user frame.
Both take the six numbers of the keys xyz_mm and rpy_deg of [tool] and [[frame]] in scenarios, and also apply to files.
The angles of --rpy are rotations about the fixed axes x, then y, then z.
For a file, one line on standard error counts the poses that were solved for the nearest orientation (five joints) or
clamped at the reach limit.
Exit code: 0 ok, 1 the single pose has no branch within the limits, 2 bad input (then nothing is written).)";

struct IkOptions {
  PoseFileOptions files;
  OutputOptions output;
  std::vector<std::string> xyz, rpy;  // one pose: mm and deg as written; otherwise empty
  std::vector<std::string> previous;  // with a pose: previous joint angles [deg]; empty: all 0
};

constexpr double kNoDeviationDeg = 1e-9;  // rounding

std::string singular_text(const IkBranch& branch) {
  std::string text;
  const auto add = [&text](bool present, std::string_view name) {
    if (present) text.append(text.empty() ? "; singular: " : ", ").append(name);
  };
  add((branch.singular & kShoulderSingular) != 0, "shoulder");
  add((branch.singular & kElbowSingular) != 0, "elbow");
  add((branch.singular & kWristSingular) != 0, "wrist");
  add((branch.singular & kFoldedSingular) != 0, "folded onto axis 2");
  return text + (branch.clamped ? "; at the reach limit" : "");
}

// The duration of a joint move at full speed, set by the slowest joint. The choice of a branch compares it.
double seconds_from(const JointAngles& previous, const JointAngles& joints, const RobotModel& model) {
  double seconds = 0;
  for (std::size_t i = 0; i < model.axis_count; ++i) {
    const double rad = std::fabs(joints[i].value() - previous[i].value());
    seconds = std::max(seconds, rad / AxisUnits{model.axes[i]}.max_speed_rad_s());
  }
  return seconds;
}

std::string verdict(const IkSolutions& solutions, std::size_t branch, const JointAngles& previous,
                    const ArmOfFile& robot) {
  const IkBranch& b = solutions.branches[branch];
  if (!b.within_limits) {
    const std::size_t joint = b.outside_axis - 1u;
    const AxisSpec& axis = robot.spec.axes.at(joint);
    return fmt::format("joint {} is outside {} .. {}", joint + 1, number_text(axis.min_deg), number_text(axis.max_deg));
  }
  const bool selected = static_cast<int>(branch) == solutions.selected;
  return fmt::format("{:.3f} s away{}", seconds_from(previous, b.joints, robot.model), selected ? ", SELECTED" : "");
}

std::string solutions_table(const IkSolutions& solutions, const JointAngles& previous, const PoseFrames& frames,
                            const ArmOfFile& robot) {
  std::string text = frames.point() + " of " + printable(robot.spec.name) + ": ";
  if (solutions.count == 0) return text + "no solution, " + no_solution_text(solutions) + "\n";
  auto out = std::back_inserter(text);
  fmt::format_to(out, "{} solution{}{}\n", solutions.count, solutions.count == 1 ? "" : "s",
                 solutions.selected < 0 ? ", none of them inside the limits" : "");
  if (const double turned_deg = solutions.residual_rad * kDegPerRad; turned_deg > kNoDeviationDeg) {
    fmt::format_to(out, "for the nearest orientation that five joints can reach, {:.6f} deg away\n", turned_deg);
  }
  const bool flips = robot.model.arm.family == ArmFamily::kSixR;
  fmt::format_to(out, "branch shoulder  elbow{}", flips ? "  wrist" : "");
  for (std::size_t i = 0; i < robot.spec.axis_count; ++i) fmt::format_to(out, "{:>12}_deg", fmt::format("j{}", i + 1));
  text += "   from the joints before\n";
  for (std::size_t branch = 0; branch < solutions.count; ++branch) {
    const IkBranch& b = solutions.branches[branch];
    const Configuration sides = Arm::configuration(b);
    fmt::format_to(out, "{:>6} {:>8} {:>6}", branch, side_text(sides.shoulder), side_text(sides.elbow));
    if (flips) fmt::format_to(out, " {:>6}", side_text(sides.wrist));
    for (std::size_t i = 0; i < robot.spec.axis_count; ++i) {
      text += table_number(b.joints[i].value() * kDegPerRad, 9, 16);
    }
    fmt::format_to(out, "   {}{}\n", verdict(solutions, branch, previous, robot), singular_text(b));
  }
  return text;
}

nlohmann::ordered_json solutions_json(const IkSolutions& solutions, const JointAngles& previous,
                                      const ArmOfFile& robot) {
  using Json = nlohmann::ordered_json;
  Json json = {{"robot", robot.spec.name},
               {"selected", solutions.selected >= 0 ? Json(solutions.selected) : Json(nullptr)},
               {"no_solution", solutions.count == 0 ? Json(no_solution_text(solutions)) : Json(nullptr)},
               {"orientation_missed_deg", solutions.residual_rad * kDegPerRad},
               {"branches", Json::array()}};
  const bool flips = robot.model.arm.family == ArmFamily::kSixR;
  for (std::size_t i = 0; i < solutions.count; ++i) {
    const IkBranch& branch = solutions.branches[i];
    const Configuration sides = Arm::configuration(branch);
    Json joints_deg = Json::array();
    for (std::size_t axis = 0; axis < robot.spec.axis_count; ++axis) {
      joints_deg.push_back(branch.joints[axis].value() * kDegPerRad);
    }
    json["branches"].push_back({{"joints_deg", std::move(joints_deg)},
                                {"shoulder", side_text(sides.shoulder)},
                                {"elbow", side_text(sides.elbow)},
                                {"wrist", flips ? Json(side_text(sides.wrist)) : Json(nullptr)},
                                {"within_limits", branch.within_limits},
                                {"outside_joint", branch.within_limits ? Json(nullptr) : Json(branch.outside_axis)},
                                {"singular", singularity_names(branch.singular)},
                                {"at_reach_limit", branch.clamped},
                                {"seconds_away", seconds_from(previous, branch.joints, robot.model)}});
  }
  return json;
}

// Counts the poses of a file whose solutions do not meet the pose exactly. The file of solutions does not show this.
class Deviations {
 public:
  void add(const IkSolutions& solutions) {
    const std::size_t pose = poses_++;
    if (solutions.count == 0) return;
    const double off_deg = solutions.residual_rad * kDegPerRad;
    if (off_deg > kNoDeviationDeg) projected_.add(pose);
    if (off_deg > largest_deg_) largest_deg_ = off_deg;
    const std::span branches = std::span{solutions.branches}.first(solutions.count);
    if (std::ranges::any_of(branches, &IkBranch::clamped)) at_reach_limit_.add(pose);
  }

  // One line. Empty if every pose is met.
  [[nodiscard]] std::string text(const std::string& file) const {
    std::string text;
    if (projected_.count > 0) {
      text = fmt::format("{} solved for the nearest orientation that five joints can reach, up to {:.6g} deg away",
                         projected_.text(), largest_deg_);
    }
    if (at_reach_limit_.count > 0) {
      text += (text.empty() ? "" : "; ") + at_reach_limit_.text() + " at the reach limit";
    }
    return text.empty() ? text : fmt::format("{}: of {} poses {}\n", printable(file, kShowAll), poses_, text);
  }

 private:
  struct Tally {
    std::size_t count = 0;
    std::size_t first = 0;
    void add(std::size_t pose) {
      if (count++ == 0) first = pose;
    }
    [[nodiscard]] std::string text() const { return fmt::format("{} (first: pose {})", count, first); }
  };
  std::size_t poses_ = 0;
  double largest_deg_ = 0;
  Tally projected_, at_reach_limit_;
};

int solve_one(const IkOptions& given, const ArmOfFile& robot) {
  constexpr double kMaxTurnDeg = 36'000;
  const auto xyz = parse_arguments("--xyz (mm)", given.xyz, 3, kMaxPositionMm);
  const auto rpy = parse_arguments("--rpy (deg)", given.rpy, 3, kMaxTurnDeg);
  JointAngles previous{};
  if (!given.previous.empty()) {
    previous = to_radians(parse_arguments("--previous (deg)", given.previous, robot.spec.axis_count, kMaxJointDeg));
  }
  const Transform pose{rotation_from_rpy(rpy[0] * kRadPerDeg, rpy[1] * kRadPerDeg, rpy[2] * kRadPerDeg),
                       {xyz[0], xyz[1], xyz[2]}};
  const PoseFrames frames = given.files.frames();
  const IkSolutions solutions = robot.arm.inverse(frames.flange(pose), previous);
  if (given.output.json) {
    print_json(solutions_json(solutions, previous, robot));
  } else {
    write_output("-", solutions_table(solutions, previous, frames, robot));
  }
  return solutions.selected >= 0 ? kExitOk : kExitCheckFailed;
}

int run(const IkOptions& given, const SearchPath& path) {
  const ArmOfFile robot = load_arm(given.files.robot, path);
  if (!given.files.in) return solve_one(given, robot);
  require_output(given.files.out, *given.files.in, robot);
  const TextInput input = read_input(*given.files.in);
  const PoseFrames frames = given.files.frames();
  SolutionsText solutions{robot.spec.axis_count};
  Deviations deviations;
  for (const PoseRow& row : parse_poses(input.text, input.name, robot.spec.axis_count)) {
    const IkSolutions solved = robot.arm.inverse(frames.flange(row.pose), to_radians(row.previous_deg));
    solutions.add(solved);
    deviations.add(solved);
  }
  write_output(given.files.out, solutions.text());
  std::cerr << deviations.text(input.name);
  return kExitOk;
}

CommandAction declare_ik(CLI::App& app) {
  const auto options = std::make_shared<IkOptions>();
  add_pose_file_options(app, options->files, "File of poses, '-' for standard input",
                        "File for the solutions (default '-', standard output)");
  CLI::Option* xyz = app.add_option("--xyz", options->xyz, "Position of one pose [mm]")->expected(3)->excludes("--in");
  CLI::Option* rpy =
      app.add_option("--rpy", options->rpy, "Roll, pitch and yaw of the pose [deg]")->expected(3)->needs(xyz);
  xyz->needs(rpy);
  app.add_option("--previous", options->previous, "Previous joint angles [deg] (default: all 0)")->expected(1, 6);
  add_json_option(app, options->output);
  app.get_option("--json")->excludes("--in");
  app.callback([options] {
    if (!options->previous.empty() && options->files.in) {
      throw CLI::ValidationError("--previous",
                                 "belongs to --xyz; a file has the joints before in columns prev1_deg,...");
    }
    if (!options->files.in && options->xyz.empty()) throw CLI::RequiredError("--xyz and --rpy, or --in,");
  });
  return [options](const CommonOptions& common) { return run(*options, common.search_path()); };
}

}  // namespace

Subcommand ik_command() {
  return {.name = "ik",
          .order = 60,
          .summary = "Inverse kinematics: all joint angles that bring the flange or a tool to a pose",
          .details = kIkDetails,
          .stray = "give a pose with --xyz X Y Z and --rpy ROLL PITCH YAW",
          .declare = declare_ik};
}

}  // namespace armature::cosim
