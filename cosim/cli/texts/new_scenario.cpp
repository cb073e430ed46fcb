#include "cosim/cli/texts/new_scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "cosim/text/input_error.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

constexpr double kMoveAtS = 0.05;
constexpr double kRestS = 0.3;                                           // for the drives, after the set-points
constexpr std::array<double, kAxes> kWishDeg{20, -15, 15, 10, -20, 30};  // inside the ranges of most arms

// To a whole number of steps, of which `steps` make 1. The quotient is the number nearest to its decimal text.
double rounded_up(double value, double steps) {
  return std::ceil(value * steps - 1e-9) / steps;
}

// Inside the range of the axis, with a tenth of it free at both ends.
double target_deg(const AxisSpec& axis, double wish_deg) {
  const double margin_deg = 0.1 * (axis.max_deg - axis.min_deg);
  return std::round(std::clamp(wish_deg, axis.min_deg + margin_deg, axis.max_deg - margin_deg));
}

std::vector<double> targets_deg(const RobotSpec& robot) {
  std::vector<double> targets;
  for (std::size_t i = 0; i < robot.axis_count; ++i) targets.push_back(target_deg(robot.axes[i], kWishDeg[i]));
  return targets;
}

// Not less than the joint move takes: each axis at full speed, and one acceleration.
double move_s(const RobotSpec& robot, const std::vector<double>& targets) {
  double longest_s = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const AxisSpec& axis = robot.axes[i];
    longest_s = std::max(longest_s,
                         std::fabs(targets[i]) / axis.max_speed_deg_s + axis.max_speed_deg_s / axis.max_accel_deg_s2);
  }
  return longest_s;
}

// Two steps of the coarsest axis, and not less than what everybody can read.
double tolerance_deg(const RobotSpec& robot) {
  double tolerance = 0.01;
  for (std::size_t i = 0; i < robot.axis_count; ++i) {
    const AxisSpec& axis = robot.axes[i];
    const std::int32_t counts = std::min(axis.pulses_per_rev, kCountsPerLine * axis.encoder_lines);
    tolerance = std::max(tolerance, 2 * 360 / (axis.gear_ratio * counts));
  }
  return rounded_up(tolerance, 100);
}

std::string list(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number_text(value);
  return "[" + text + "]";
}

// `key = value`, and a comment in a column of its own.
std::string key_line(std::string_view key, const std::string& value, std::string_view comment) {
  return fmt::format("{:<28}  # {}\n", fmt::format("{} = {}", key, value), comment);
}

}  // namespace

std::string new_scenario(const std::string& name, const std::string& robot_key, const RobotSpec& robot,
                         const std::string& schema) {
  const std::vector<double> targets = targets_deg(robot);
  const double moving_s = move_s(robot, targets);
  std::string text;
  text += "#:schema " + schema + "\n";
  text += fmt::format("# Run it:  armature run {} --report\n", name);
  text += fmt::format("# See it:  out/{}/report.html in a browser\n\n", name);
  text += "description = \"A joint move of all axes\"\n";
  text += key_line("robot", '"' + robot_key + '"', "'armature list' shows the others");
  text += key_line("duration_s", number_text(rounded_up(kMoveAtS + moving_s + kRestS, 10)), "simulated time");
  text += R"(
# A command for the controller. All axes begin and end together: the slowest one sets the duration. Add more [[move]]
# tables; a move waits for the end of the one before.
[[move]]
)";
  text += key_line("at_s", number_text(kMoveAtS), "when the controller gets it");
  text += key_line("type", "\"joint\"", "or \"line\", \"arc\", \"hold\", \"jog\", \"home\", ...");
  text += fmt::format("target_deg = {}  # of each axis; the arm begins at 0\n", list(targets));
  text += R"(
# Something goes wrong: the drive of axis 1 misses 100 pulses. The controller sees it at the encoder and corrects it.
#[[fault]]
)";
  text += fmt::format("#at_s = {}\n", number_text(std::round((kMoveAtS + moving_s / 4) * 1000) / 1000));
  text += R"(#kind = "pulse_loss"
#axis = 1
#count = 100

# What the run must fulfil. If it does not, the run fails.
[expect]
)";
  text += fmt::format("final_joint_deg = {}\n", list(targets));
  text += key_line("tolerance_deg", number_text(tolerance_deg(robot)), "of these angles, measured by the encoders");
  text += key_line("underruns", "0", "core 0 is never late");
  text += fmt::format(R"(
# 'armature bless {0}' makes a run that passes the golden. Then 'armature check {0}' compares every tick with it.
# 'armature watch {0}' runs the scenario whenever you save this file. KEYS.md explains all keys.
)",
                      name);
  return text;
}

std::string bare_scenario(const std::string& robot_key) {
  return fmt::format(R"(# Written by 'armature live --robot'.
description = "The robot alone"
robot = "{}"
duration_s = 1

[pendant]
profile = "extended"
)",
                     robot_key);
}

std::string robot_key(const std::string& robot, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  const bool is_path = robot.ends_with(".toml");
  std::string key = is_path ? fs::proximate(fs::absolute(robot), fs::absolute(folder)).string() : robot;
  if (key.find_first_of("\"\\") != std::string::npos || printable(key, kShowAll) != key) {
    throw InputError{robot, "has characters that a scenario cannot have in the key 'robot'; rename the file"};
  }
  return key;
}

}  // namespace armature::cosim
