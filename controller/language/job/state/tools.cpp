#include "controller/language/job/state/tools.hpp"

namespace armature::job {

const Transform* Tools::stated(std::uint8_t tool) const noexcept {
  if (tool >= setup_.settings.flange_T_tool.size()) return nullptr;
  const std::optional<Transform>& stated = setup_.settings.flange_T_tool[tool];
  return stated ? &*stated : nullptr;
}

Transform Tools::arm_T_tool(std::uint8_t tool) const noexcept {
  const Transform* const other = stated(tool);
  return other == nullptr ? Transform{} : inverse(setup_.cell.flange_T_tool) * *other;
}

Alarm Tools::use(std::uint8_t tool) noexcept {
  if (stated(tool) == nullptr) {
    if (arm_tool_ && *arm_tool_ != tool) return Alarm::kTool;
    arm_tool_ = tool;
  }
  present_ = tool;
  return Alarm::kNone;
}

}  // namespace armature::job
