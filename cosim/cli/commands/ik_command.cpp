#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/kinematics/chip_solutions.hpp"
#include "cosim/cli/kinematics/console_solutions.hpp"
#include "cosim/cli/kinematics/solutions_report.hpp"
#include "cosim/cli/kinematics/solved_on.hpp"
#include "cosim/cli/options/kinematics_io.hpp"
#include "cosim/cli/options/output_options.hpp"
#include "cosim/cli/options/word_option.hpp"
#include "cosim/poses/pose_files.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kIkDetails = R"(Examples:
  armature ik --robot abb_irb120 --xyz 350 -120 500 --rpy 30 120 -10
  armature ik --robot abb_irb120 --xyz 350 -120 500 --rpy 30 120 -10 --previous 0 0 0 90 0 -90
  armature ik --robot abb_irb120 --xyz -20 80 500 --rpy 30 120 -10 --tool 0 0 120 0 0 0 --frame 300 -100 0 0 0 90
  armature ik --robot abb_irb120 --xyz 350 -120 500 --rpy 30 120 -10 --json
  armature ik --robot abb_irb120 --xyz 350 -120 500 --rpy 30 120 -10 --on cordic
  armature ik --robot abb_irb120 --in poses.csv --out solutions.csv

--on cordic: a chip (the model of the logic) solves the pose by its block ik_cordic. Below the solutions are the clocks of 20 ns
that this takes, in the block and with all accesses of the bus, and the largest difference of a joint angle from those that the
host computes (--on host, the default), in pulses of its motor. A pose of five axes is projected by the host first.
--on a9 (armature-iss only): the firmware solves the pose on a Cortex-A9 and shows the joint angles on its serial line of
115200 baud, as the program of Hu 2012 does on a Nios II. Below the solutions are this text, and the instructions of the inverse
kinematics with their time, at 1.5 clocks of 667 MHz for each, in clocks of 20 ns.
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
  std::optional<SolvedOn> on;         // with a pose; none: kHost
};

// Counts the poses of a file whose solutions do not meet the pose exactly. The file of solutions does not show this.
class Deviations {
 public:
  void add(const IkSolutions& solutions) {
    const std::size_t pose = poses_++;
    if (solutions.count == 0) return;
    const double off_deg = solutions.residual_rad * kDegPerRad;
    if (off_deg > kMetWithinDeg) projected_.add(pose);
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

struct Found {
  IkSolutions solutions;
  std::string text{};  // below the table of solutions
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
};

template <class Solutions>
Found found_by(const Solutions& solutions) {
  Found found{.solutions = solutions.solutions, .text = solutions.text()};
  solutions.add_to(found.json);
  return found;
}

Found solve(SolvedOn on, const ArmOfFile& robot, const Transform& base_T_flange, const JointAngles& previous) {
  switch (on) {
    case SolvedOn::kCordic:
      return found_by(solve_on_chip(robot, base_T_flange, previous));
    case SolvedOn::kA9:
      return found_by(solve_on_a9(robot, base_T_flange, previous));
    case SolvedOn::kHost:
      break;
  }
  return {.solutions = robot.arm.inverse(base_T_flange, previous)};
}

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
  const Transform base_T_flange = frames.flange(pose);
  const Found found = solve(given.on.value_or(SolvedOn::kHost), robot, base_T_flange, previous);
  if (given.output.json) {
    nlohmann::ordered_json json = solutions_json(found.solutions, previous, robot);
    json.update(found.json);
    print_json(json);
  } else {
    write_output("-", solutions_table(found.solutions, previous, frames, robot) + found.text);
  }
  return found.solutions.selected >= 0 ? kExitOk : kExitCheckFailed;
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
  add_word_option(app, "--on", options->on,
                  "What solves one pose: host, a9 (the firmware) or cordic (the block of the chip); default: host");
  app.get_option("--on")->excludes("--in");
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
