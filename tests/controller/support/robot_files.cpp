#include "tests/controller/support/robot_files.hpp"

#include <toml++/toml.h>

#include <cstdint>
#include <stdexcept>

#include "tests/controller/support/robots.hpp"

namespace armature::test {
namespace {

double number(const toml::table& table, const char* key) {
  const auto value = table[key].value<double>();
  if (!value) throw std::runtime_error{std::string{"no number "} + key};
  return *value;
}

}  // namespace

RobotModel robot_of_file(const std::string& name) {
  const toml::table file = toml::parse_file(std::string{ARMATURE_SOURCE_DIR} + "/scenarios/robots/" + name + ".toml");
  const toml::table& arm = *file["kinematics"].as_table();
  const toml::table& defaults = *file["defaults"].as_table();
  const toml::array& axes = *file["axis"].as_array();

  RobotModel robot;
  robot.axis_count = static_cast<std::uint32_t>(axes.size());
  const bool six = arm["family"].value_or("") == std::string{"six_r"};
  robot.arm.family = six ? ArmFamily::kSixR : ArmFamily::kFiveR;
  robot.arm.a1_mm = number(arm, "a1_mm");
  robot.arm.a2_mm = number(arm, "a2_mm");
  robot.arm.a3_mm = number(arm, "a3_mm");
  if (six) {
    robot.arm.d1_mm = number(arm, "d1_mm");
    robot.arm.d4_mm = number(arm, "d4_mm");
    robot.arm.d6_mm = number(arm, "d6_mm");
  } else {
    robot.arm.a4_mm = number(arm, "a4_mm");
    robot.arm.d5_mm = number(arm, "d5_mm");
    robot.arm.max_projection_rad = number(arm, "max_projection_deg") * kDeg;
  }
  for (std::size_t i = 0; i < robot.axis_count; ++i) {
    const toml::table& own = *axes[i].as_table();
    const auto of_axis = [&](const char* key) { return number(own.contains(key) ? own : defaults, key); };
    AxisModel& axis = robot.axes[i];
    axis.gear_ratio = of_axis("gear_ratio");
    axis.pulses_per_rev = static_cast<std::int32_t>(of_axis("pulses_per_rev"));
    axis.counts_per_rev = 4 * static_cast<std::int32_t>(of_axis("encoder_lines"));
    axis.min_rad = of_axis("min_deg") * kDeg;
    axis.max_rad = of_axis("max_deg") * kDeg;
    axis.max_speed_rad_s = of_axis("max_speed_deg_s") * kDeg;
    axis.max_accel_rad_s2 = of_axis("max_accel_deg_s2") * kDeg;
    axis.max_jerk_rad_s3 = of_axis("max_jerk_deg_s3") * kDeg;
    robot.arm.sign[i] = arm["sign"][i].value<double>().value();
    robot.arm.offset_rad[i] = arm["offset_deg"][i].value<double>().value() * kDeg;
  }
  return robot;
}

}  // namespace armature::test
