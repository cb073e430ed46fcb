#include "controller/activity/homing/homing_activity.hpp"

#include "controller/activity/homing/homing_request.hpp"
#include "controller/activity/move_checks.hpp"

namespace armature {

std::optional<MoveRefused> HomingActivity::accept(const Home& home) noexcept {
  if (std::optional<MoveRefused> refusal = find_refusal(robot_, home)) return refusal;
  if (!owner_.rest()) return MoveRefused{.reason = Refusal::kNotReady};
  const auto all = static_cast<std::uint8_t>((1u << robot_.axis_count) - 1u);
  owner_.begin(ActivityId::kHoming, HomingRequest{.axes = home.axes == 0 ? all : home.axes, .tag = home.tag});
  return std::nullopt;
}

}  // namespace armature
