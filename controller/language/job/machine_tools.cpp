// The tools of a program. The planner knows one, that of the arm; the poses of another one are converted to it.
#include "controller/language/job/machine.hpp"

namespace armature::job {
namespace {

constexpr double kSamePlace_mm = 1e-6;
constexpr double kSameTurn = 1e-9;  // of the elements of rotations

}  // namespace

const Transform* Machine::stated_tool(std::uint8_t tool) const noexcept {
  if (tool >= setup_.settings.flange_T_tool.size()) return nullptr;
  const std::optional<Transform>& stated = setup_.settings.flange_T_tool[tool];
  return stated ? &*stated : nullptr;
}

Transform Machine::arm_T_tool(std::uint8_t tool) const noexcept {
  const Transform* const stated = stated_tool(tool);
  return stated == nullptr ? Transform{} : inverse(setup_.cell.flange_T_tool) * *stated;
}

// The arm carries one tool, by any number, and those that the settings state.
bool Machine::use_tool(std::uint8_t tool) noexcept {
  if (stated_tool(tool) == nullptr) {
    if (arm_tool_ && *arm_tool_ != tool) return fail(Alarm::kTool);
    arm_tool_ = tool;
  }
  tool_ = tool;
  return true;
}

// On a line or an arc the tool of the arm and the present one move alike only while they do not turn.
bool Machine::keeps_tool_path(const Transform& base_T_tool) noexcept {
  if (arm_T_tool(tool_.value_or(0)).position_mm.norm() < kSamePlace_mm) return true;
  if (!know_pose()) return false;
  const bool turns = (planned_.base_T_tool->rotation - base_T_tool.rotation).norm() > kSameTurn;
  return !turns || fail(Alarm::kToolTurns);
}

}  // namespace armature::job
