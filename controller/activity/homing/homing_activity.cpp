#include "controller/activity/homing/homing_activity.hpp"

#include <cassert>

#include "controller/activity/move_checks.hpp"

namespace armature {

std::optional<MoveRefused> HomingActivity::accept(const Home& home) noexcept {
  if (std::optional<MoveRefused> refusal = find_refusal(robot_, home)) return refusal;
  if (!owner_.rest()) return MoveRefused{.reason = Refusal::kNotReady};
  const auto all = static_cast<std::uint8_t>((1u << robot_.axis_count) - 1u);
  send({.axes = home.axes == 0 ? all : home.axes, .tag = home.tag});
  owner_.lend(ActivityId::kHoming);
  return std::nullopt;
}

void HomingActivity::stop(StopKind) noexcept {
  if (!owner_.has(ActivityId::kHoming)) return;
  send({});
  owner_.await_rest();
}

void HomingActivity::send(const HomingRequest& request) noexcept {
  [[maybe_unused]] const bool pushed = mailbox_.homings.try_push(request);
  assert(pushed);  // a request and its stop at most; the ones before were answered
}

}  // namespace armature
