#include "cosim/cli/options/kinematics_io.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/poses/number_csv.hpp"
#include "cosim/scenario/files/robot_loader.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

constexpr int kPlaceNumbers = 6;

// Values in the form and ranges of the keys `xyz_mm` and `rpy_deg`. None without a text.
std::optional<Transform> parse_place(const char* option, const std::vector<std::string>& texts) {
  if (texts.empty()) return std::nullopt;
  const auto three = [&](const char* unit, std::size_t first, double largest) {
    const auto values =
        parse_arguments(fmt::format("{} ({})", option, unit), std::span{texts}.subspan(first, 3), 3, largest);
    return std::array{values[0], values[1], values[2]};
  };
  return to_transform({.xyz_mm = three("mm", 0, kMaxPlaceMm), .rpy_deg = three("deg", 3, kMaxAngleDeg)});
}

}  // namespace

PoseFrames PoseFileOptions::frames() const {
  return {.flange_T_tool = parse_place("--tool", tool), .base_T_user = parse_place("--frame", frame)};
}

void add_pose_file_options(CLI::App& command, PoseFileOptions& options, const char* in_help, const char* out_help) {
  command.add_option("--robot", options.robot, "Name from 'armature list', or a path ending in .toml")
      ->required()
      ->type_name(kRobotValue);
  CLI::Option* in = command.add_option("--in", options.in, in_help)->type_name(kFileValue);
  command.add_option("--out", options.out, out_help)->needs(in)->type_name(kFileValue);
  // Extra numbers are joint angles of `fk`.
  command.add_option("--tool", options.tool, "Pose of the tool on the flange, x y z [mm] roll pitch yaw [deg]")
      ->expected(kPlaceNumbers)
      ->allow_extra_args(false);
  command.add_option("--frame", options.frame, "User frame in the base, x y z [mm] roll pitch yaw [deg]")
      ->expected(kPlaceNumbers)
      ->allow_extra_args(false);
}

ArmOfFile load_arm(const std::string& robot, const SearchPath& path) {
  RobotSpec spec = find_robot(robot, path);
  if (!spec.kinematics) throw InputError{robot, "has no [kinematics]: the dimensions of this arm are not known"};
  const RobotModel model = to_robot_model(spec);
  return {std::move(spec), model, Arm{model}};
}

namespace {

template <class Side>
std::string_view side_name(Side side) {
  return side == Side::kNearest ? "either" : word_of(side);
}

}  // namespace

std::string_view side_text(ShoulderSide side) {
  return side_name(side);
}
std::string_view side_text(ElbowSide side) {
  return side_name(side);
}
std::string_view side_text(WristSide side) {
  return side_name(side);
}

std::string configuration_text(const Configuration& configuration, const ArmOfFile& robot) {
  std::string text =
      fmt::format("shoulder {}, elbow {}", side_text(configuration.shoulder), side_text(configuration.elbow));
  if (robot.model.arm.family == ArmFamily::kSixR) text += fmt::format(", wrist {}", side_text(configuration.wrist));
  if (!configuration.turns) return text;
  text += ", turns";
  for (std::size_t i = 0; i < robot.spec.axis_count; ++i) text += fmt::format(" {}", (*configuration.turns)[i]);
  return text;
}

JointAngles to_radians(const PerAxis<double>& deg) {
  return make_per_axis([&](std::size_t axis) { return Radians{deg[axis] * kRadPerDeg}; });
}

PerAxis<double> parse_arguments(std::string_view what, std::span<const std::string> texts, std::size_t count,
                                double largest) {
  if (texts.size() != count) {
    throw InputError{std::string{what}, fmt::format("expected {} numbers, found {}", count, texts.size())};
  }
  PerAxis<double> values{};
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<double> value = parse_number(texts[i]);
    if (!value || std::fabs(*value) > largest) {
      throw InputError{std::string{what},
                       fmt::format("expected a number from {} to {}, found \"{}\"", number_text(-largest),
                                   number_text(largest), printable(texts[i]))};
    }
    values[i] = *value;
  }
  return values;
}

std::string table_number(double value, int digits, int width) {
  const bool nothing = std::fabs(value) < 0.5 * std::pow(10.0, -digits);
  return fmt::format("{:>{}.{}f}", nothing ? 0.0 : value, width, digits);
}

TextInput read_input(const std::string& file) {
  if (file != "-") return {file, read_text_file(file, kMaxTableBytes)};
  TextInput input{"standard input", {}};
  input.text = read_text(std::cin, input.name, kMaxTableBytes);
  if (std::ferror(stdin) != 0) throw InputError{input.name, "cannot read"};
  return input;
}

void require_output(const std::string& out, const std::string& in, const ArmOfFile& robot) {
  if (out == "-") return;
  OutputFiles files;
  files.reads(robot.spec.source.file);
  files.reads(in == "-" ? "/dev/stdin" : in);
  files.writes(out, "--out", Writing::kInPlace);
}

void write_output(const std::string& file, std::string_view text) {
  if (file != "-") {
    replace_text_file(file, text);
    return;
  }
  std::cout.write(text.data(), static_cast<std::streamsize>(text.size()));
}

}  // namespace armature::cosim
