// What `fk` and `ik` share: their common options, the arm, numbers of the command line, files that may be standard
// input and output.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/angle_units.hpp"
#include "controller/kinematics/arm.hpp"
#include "cosim/poses/pose_frames.hpp"
#include "cosim/robot/robot_spec.hpp"
#include "cosim/scenario/files/search_path.hpp"

namespace CLI {
class App;
}

namespace armature::cosim {

struct PoseFileOptions {
  std::string robot;               // --robot: name from `armature list`, or a path ending in .toml
  std::optional<std::string> in;   // --in: a file of joints or poses; "-" is standard input
  std::string out = "-";           // --out: "-" is standard output
  std::vector<std::string> tool;   // --tool: x y z [mm] roll pitch yaw [deg] as written; empty: the flange
  std::vector<std::string> frame;  // --frame: the same of a user frame; empty: the base

  // Throws InputError when a number is none or out of range.
  [[nodiscard]] PoseFrames frames() const;
};

// Adds these options to `command`; `options` must outlive the parsing.
void add_pose_file_options(CLI::App& command, PoseFileOptions& options, const char* in_help, const char* out_help);

struct ArmOfFile {
  RobotSpec spec;
  RobotModel model;
  Arm arm;
};

// Throws InputError when there is no such robot, or its file is wrong or has no [kinematics].
[[nodiscard]] ArmOfFile load_arm(const std::string& robot, const SearchPath& path);

// `either` for a side that is not determined at a singularity.
[[nodiscard]] std::string_view side_text(ShoulderSide side);
[[nodiscard]] std::string_view side_text(ElbowSide side);
[[nodiscard]] std::string_view side_text(WristSide side);
// `shoulder front, elbow up, wrist noflip, turns 0 0 0 0 0 0`: the keys of a [[move]] and their values.
[[nodiscard]] std::string configuration_text(const Configuration& configuration, const ArmOfFile& robot);

// The angles [rad] of a row of joints.
[[nodiscard]] JointAngles to_radians(const PerAxis<double>& deg);

// The numbers of an argument. There must be `count`, each from -largest to largest; the other elements become 0. `what`
// names the argument and the unit in messages. Throws InputError.
[[nodiscard]] PerAxis<double> parse_arguments(std::string_view what, std::span<const std::string> texts,
                                              std::size_t count, double largest);

// With `digits` digits after the point. A value that rounds to 0 has no sign.
[[nodiscard]] std::string table_number(double value, int digits, int width);

// "-" is standard input.
struct TextInput {
  std::string name;  // for messages
  std::string text;
};
[[nodiscard]] TextInput read_input(const std::string& file);

// Throws InputError when `out` cannot be written, or is the file of the robot or `in`. "-": as in write_output().
void require_output(const std::string& out, const std::string& in, const ArmOfFile& robot);

// "-" is standard output. A file is replaced as a whole.
void write_output(const std::string& file, std::string_view text);

}  // namespace armature::cosim
