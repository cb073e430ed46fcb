#include "cosim/cli/kinematics_command.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <iterator>
#include <stdexcept>

#include "cosim/poses/number_csv.hpp"
#include "cosim/scenario/robot_loader.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {

ArmOfFile load_arm(const std::string& robot, const SearchPath& path) {
  RobotSpec spec = find_robot(robot, path);
  if (!spec.kinematics) throw InputError{robot, "has no [kinematics]: the dimensions of this arm are not known"};
  const RobotModel model = to_robot_model(spec);
  return {std::move(spec), model, Arm{model}};
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
      throw InputError{std::string{what}, fmt::format("expected a number from {} to {}, found \"{}\"",
                                                      number_text(-largest), number_text(largest), texts[i])};
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
  if (file != "-") return {file, read_text_file(file)};
  TextInput input{"standard input", {std::istreambuf_iterator<char>{std::cin}, {}}};
  if (std::cin.bad()) throw InputError{input.name, "cannot read"};
  return input;
}

void write_output(const std::string& file, std::string_view text) {
  if (file != "-") {
    replace_text_file(file, text);
    return;
  }
  std::cout.write(text.data(), static_cast<std::streamsize>(text.size())).flush();
  if (!std::cout) throw std::runtime_error{"cannot write to standard output"};
}

}  // namespace armature::cosim
