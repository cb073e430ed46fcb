#include "controller/activity/homing/homing_activity.hpp"

#include "controller/activity/homing/homing_request.hpp"
#include "controller/activity/move_checks.hpp"

namespace armature {

std::optional<MoveRefused> HomingActivity::accept(const Home& home) noexcept {
  if (std::optional<MoveRefused> refusal = find_refusal(context_.robot, home)) return refusal;
  if (!context_.owner.rest()) return refused(Refusal::kNotReady);
  const auto all = static_cast<std::uint8_t>((1u << context_.robot.axis_count) - 1u);
  context_.owner.begin(ActivityId::kHoming, HomingRequest{.axes = home.axes == 0 ? all : home.axes, .tag = home.tag});
  return std::nullopt;
}

}  // namespace armature
