#include "cosim/scenario/robot_loader.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string_view>
#include <system_error>

#include "controller/core/timebase.hpp"
#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "cosim/scenario/kinematics_table.hpp"
#include "cosim/scenario/table_reader.hpp"
#include "cosim/scenario/toml_document.hpp"
#include "cosim/text/angle_units.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/suggest.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

constexpr double kMaxPulseRateHz = 4e6;  // the logic emits at most 200 pulses in 50 us
// Below this the logic's debounce would take the encoder's edges for glitches.
constexpr std::int64_t kMinCyclesPerCount = regs::encoder::kDebounceTimeReset + 1;
constexpr double kMaxTurns = 100.0;  // joint range, far beyond any arm: keeps counts in range
constexpr double kNsPerCycle = 1e9 / static_cast<double>(kClkFreqHz);
constexpr double kRounding = 1e-12;  // relative; lets a limit be met exactly
constexpr double kDegPerSecToRpm = 60.0 / 360.0;

void read_drive(TableReader& reader, DriveSpec& drive) {
  constexpr double kMaxDirNs = regs::pulse_train::kDirSetupValueMask * kNsPerCycle;  // width of the registers
  reader.read("natural_hz", drive.natural_hz, between(1, 1000, "Hz"));
  reader.read("damping", drive.damping, between(0.1, 10));
  reader.read("max_speed_rpm", drive.max_speed_rpm, above(0, 100'000, "rpm"));
  reader.read("max_torque_nm", drive.max_torque_nm, above(0, 10'000, "N m"));
  reader.read("inertia_kg_m2", drive.inertia_kg_m2, above(0, 100, "kg m^2"));
  reader.read("min_step_high_ns", drive.min_step_high_ns, between(0, 50'000, "ns"));
  reader.read("min_step_low_ns", drive.min_step_low_ns, between(0, 50'000, "ns"));
  reader.read("dir_setup_ns", drive.dir_setup_ns, between(0, kMaxDirNs, "ns"));
  reader.read("dir_hold_ns", drive.dir_hold_ns, between(0, kMaxDirNs, "ns"));
}

void read_axis(TableReader& reader, AxisSpec& axis) {
  constexpr double kMaxPulsesPerRev = std::numeric_limits<std::int32_t>::max();
  constexpr double kMaxLines = regs::encoder::kCountsPerRevValueMask / kCountsPerLine;  // width of the register
  constexpr double kMaxDeg = kMaxTurns * 360.0;
  reader.read("gear_ratio", axis.gear_ratio, between(-10'000, 10'000), Need::kRequired);
  reader.read("pulses_per_rev", axis.pulses_per_rev, between(1, kMaxPulsesPerRev), Need::kRequired);
  reader.read("encoder_lines", axis.encoder_lines, between(1, kMaxLines), Need::kRequired);
  reader.read("min_deg", axis.min_deg, between(-kMaxDeg, kMaxDeg, "deg"), Need::kRequired);
  reader.read("max_deg", axis.max_deg, between(-kMaxDeg, kMaxDeg, "deg"), Need::kRequired);
  reader.read("max_speed_deg_s", axis.max_speed_deg_s, above(0, 100'000, "deg/s"), Need::kRequired);
  reader.read("max_accel_deg_s2", axis.max_accel_deg_s2, above(0, 10'000'000, "deg/s^2"), Need::kRequired);
  reader.read("max_jerk_deg_s3", axis.max_jerk_deg_s3, above(0, 1e9, "deg/s^3"));
  reader.read("following_error_deg", axis.following_error_deg, above(0, 360, "deg"));
  reader.table("drive", [&](TableReader& drive) { read_drive(drive, axis.drive); });
}

// What each key allows by itself, the keys may still forbid together.
void check_axis(TableReader& reader, const AxisSpec& axis) {
  const double gear = std::fabs(axis.gear_ratio);
  if (gear < 0.01) {
    reader.problem("gear_ratio", "expected motor turns per joint turn, at least 0.01 either way, found " +
                                     number_text(axis.gear_ratio));
    return;
  }
  const auto text = [](double value) { return number_text(std::round(value * 1e3) / 1e3); };
  if (axis.min_deg >= axis.max_deg) {
    reader.problem("min_deg", "expected less than max_deg = " + number_text(axis.max_deg) + ", found " +
                                  number_text(axis.min_deg));
  }
  const double rpm = axis.max_speed_deg_s * gear * kDegPerSecToRpm;
  if (rpm > axis.drive.max_speed_rpm * (1 + kRounding)) {
    reader.problem("max_speed_deg_s", "needs " + text(rpm) + " rpm of the motor, more than drive.max_speed_rpm = " +
                                          number_text(axis.drive.max_speed_rpm));
  }
  const double pulse_rate = axis.max_speed_deg_s * gear / 360.0 * axis.pulses_per_rev;
  if (pulse_rate > kMaxPulseRateHz * (1 + kRounding)) {
    reader.problem("max_speed_deg_s", "needs " + text(pulse_rate) + " pulses/s with pulses_per_rev = " +
                                          std::to_string(axis.pulses_per_rev) + ", more than 4000000 (200 in 50 us)");
  }
  const double counts_per_rev = static_cast<double>(axis.encoder_lines) * kCountsPerLine;
  const double count_rate = axis.max_speed_deg_s * gear / 360.0 * counts_per_rev;
  if (count_rate * kMinCyclesPerCount > kClkFreqHz * (1 + kRounding)) {
    reader.problem("max_speed_deg_s", "gives " + text(count_rate) +
                                          " counts/s with encoder_lines = " + std::to_string(axis.encoder_lines) +
                                          ", less than " + std::to_string(kMinCyclesPerCount) +
                                          " clock cycles a count, which the debounce of the logic needs");
  }
  const double torque = axis.max_accel_deg_s2 * gear * kRadPerDeg * axis.drive.inertia_kg_m2;
  if (torque > axis.drive.max_torque_nm * (1 + kRounding)) {
    reader.problem("max_accel_deg_s2", "needs " + text(torque) +
                                           " N m to turn drive.inertia_kg_m2, more than drive.max_torque_nm = " +
                                           number_text(axis.drive.max_torque_nm));
  }
  // A second-order loop follows a ramp 2 damping / natural frequency late.
  const double lag_deg =
      axis.max_speed_deg_s * 2.0 * axis.drive.damping / (2.0 * std::numbers::pi * axis.drive.natural_hz);
  if (lag_deg >= axis.following_error_deg) {
    reader.problem("following_error_deg", "expected more than the drive's own lag of " + text(lag_deg) +
                                              " deg at max_speed_deg_s, found " +
                                              number_text(axis.following_error_deg));
  }
}

// The arm decides how many axes there are; `count` tables [[axis]] were found.
void check_axis_count(TableReader& reader, const RobotSpec& robot, std::size_t count) {
  if (robot.kinematics && robot.kinematics->family.empty()) return;  // not known, and reported
  if (count == robot.axis_count || (count == 0 && reader.has("axis"))) return;
  const std::string five_r = "kinematics.family = \"" + std::string{kFiveRFamily} + "\"";
  const std::string why =
      robot.axis_count == kAxes ? count == joints_of(kFiveRFamily) ? "; 5 only with " + five_r : "" : " with " + five_r;
  reader.problem("axis", "expected " + std::to_string(robot.axis_count) + " tables [[axis]]" + why + ", found " +
                             std::to_string(count));
}

}  // namespace

RobotSpec load_robot(const std::filesystem::path& file, std::vector<Problem>& all) {
  const ConfigValue root = parse_toml(read_text_file(file), file.string());
  ProblemList problems{file.string()};
  RobotSpec robot;
  TableReader reader{root, "", problems};
  reader.read("name", robot.name, anything(), Need::kRequired);
  reader.read("description", robot.description, anything());

  reader.table("kinematics", [&](TableReader& table) {
    robot.kinematics.emplace();
    read_kinematics(table, *robot.kinematics);
    if (robot.kinematics->family == kFiveRFamily) robot.axis_count = joints_of(kFiveRFamily);
  });

  const ConfigValue* defaults = nullptr;
  if (const ConfigEntry* entry = root.find("defaults")) defaults = &entry->value;
  bool defaults_good = true;
  reader.table("defaults", [&](TableReader& table) {
    AxisSpec unused;
    const std::size_t before = table.problem_count();
    table.allow_missing();
    read_axis(table, unused);
    defaults_good = table.problem_count() == before;
  });

  std::size_t index = 0;
  const std::size_t count = reader.tables("axis", [&](TableReader& table) {
    AxisSpec axis;
    const std::size_t before = table.problem_count();
    if (defaults != nullptr) table.inherit(defaults);
    read_axis(table, axis);
    if (defaults_good && table.problem_count() == before) check_axis(table, axis);
    if (index < kAxes) robot.axes[index++] = axis;
  });
  check_axis_count(reader, robot, count);
  for (std::size_t i = robot.axis_count; i < kAxes; ++i) robot.axes[i] = robot.axes[robot.axis_count - 1];
  const std::string stem = file.stem().string();
  if (!robot.name.empty() && robot.name != stem) {
    reader.problem("name", "expected the name of the file, \"" + stem + "\", found \"" + robot.name + "\"");
  }
  reader.finish();
  problems.move_to(all);
  return robot;
}

RobotSpec load_robot(const std::filesystem::path& file) {
  std::vector<Problem> problems;
  RobotSpec robot = load_robot(file, problems);
  if (!problems.empty()) throw InputError{std::move(problems)};
  return robot;
}

RobotSpec find_robot(const std::string& name, const SearchPath& search_path) {
  if (name.ends_with(".toml")) return load_robot(name);
  if (const std::optional<std::filesystem::path> file = search_path.find_robot(name)) return load_robot(*file);
  const std::vector<std::string> known = search_path.robot_names();
  throw InputError{name, "no such robot" + suggestion(name, known) + " (searched: " + search_path.searched() + ")"};
}

}  // namespace armature::cosim
