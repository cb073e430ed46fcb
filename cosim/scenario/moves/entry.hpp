// What a kind of command says about itself, and what several kinds share.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"
#include "controller/message/command.hpp"
#include "cosim/scenario/keys/key.hpp"

namespace armature::cosim {

template <class Kind>
struct MoveEntry {
  std::string_view name;                           // the value of the key `type`
  Command (*command)(const Kind&, Tag) = nullptr;  // for the controller
  std::string_view text;  // what the controller does: a main clause in Markdown, without its full stop
  bool queued = false;    // it waits in the queue of moves: moves of the arm, and commands for the tool's pins
  Keys<Kind> keys{};      // those of this kind alone
  std::string (*details)(const Kind&) = nullptr;  // what follows the name in the log: ` 30 %`; null: nothing
};

template <class Kind>
[[nodiscard]] const MoveEntry<Kind>& move_entry() = delete;

// Far beyond any arm.
inline constexpr double kMaxSpeed = 1e6;    // mm/s, deg/s
inline constexpr double kMaxAccel = 1e9;    // mm/s^2, deg/s^2
inline constexpr double kMaxJerk = 1e12;    // mm/s^3, deg/s^3
inline constexpr double kMinPercent = 0.1;  // of speeds and accelerations; slower moves take longer than any run

template <class Kind>
[[nodiscard]] Key<Kind> profile_key(ProfileKind Kind::*member, std::string_view text) {
  return named_key("profile", member, text);
}

// Whole ticks that last at least this long. A time that is a whole number of ticks except for rounding gives that
// number.
[[nodiscard]] inline Ticks at_least_ticks(double s) {
  return Ticks{static_cast<std::int64_t>(std::ceil(s / kTickSeconds - 1e-6))};
}
[[nodiscard]] inline Eigen::Vector3d to_vector(const std::array<double, 3>& xyz) {
  return {xyz[0], xyz[1], xyz[2]};
}

// The message if an S-curve of the joints lacks jerk limits of the robot; otherwise empty.
[[nodiscard]] inline std::string lacking_jerk(ProfileKind profile, const KeyContext& context) {
  const RobotSpec* robot = context.robot.spec;
  if (profile != ProfileKind::kSCurve || robot == nullptr) return {};
  const std::span axes = std::span{robot->axes}.first(robot->axis_count);
  const auto lacking = std::ranges::find_if(axes, [](const AxisSpec& axis) { return !axis.max_jerk_deg_s3; });
  if (lacking == axes.end()) return {};
  return "an S-curve of the joints needs max_jerk_deg_s3 of every axis in " + context.robot.file + "; axis " +
         std::to_string(lacking - axes.begin() + 1) + " has none";
}

}  // namespace armature::cosim
