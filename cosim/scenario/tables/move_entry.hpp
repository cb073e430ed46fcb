// What a kind of command says about itself, and what several kinds share.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/scenario/keys/key.hpp"
#include "cosim/scenario/move_spec.hpp"

namespace armature::cosim {

template <class Kind>
struct MoveEntry {
  std::string_view name;          // the value of the key `type`
  std::string_view text;          // what the controller does: a main clause in Markdown, without its full stop
  bool queued = false;            // it waits in the queue of moves: moves of the arm, and commands for the tool's pins
  std::vector<Key<Kind>> keys{};  // those of this kind alone
  std::string (*details)(const Kind&) = nullptr;  // what follows the name in the log: ` 30 %`; null: nothing
};

template <class Kind>
[[nodiscard]] const MoveEntry<Kind>& move_entry() = delete;

// The message if an S-curve of the joints lacks jerk limits of the robot; otherwise empty.
[[nodiscard]] inline std::string lacking_jerk(const std::string& profile, const KeyContext& context) {
  const RobotSpec* robot = context.robot.spec;
  if (profile != "scurve" || robot == nullptr) return {};
  const std::span axes = std::span{robot->axes}.first(robot->axis_count);
  const auto lacking = std::ranges::find_if(axes, [](const AxisSpec& axis) { return !axis.max_jerk_deg_s3; });
  if (lacking == axes.end()) return {};
  return "an S-curve of the joints needs max_jerk_deg_s3 of every axis in " + context.robot.file + "; axis " +
         std::to_string(lacking - axes.begin() + 1) + " has none";
}

}  // namespace armature::cosim
