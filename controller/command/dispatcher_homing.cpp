// Homing, and what is refused while joint angles are not known.
#include <cassert>

#include "controller/command/dispatcher.hpp"
#include "controller/command/move_checks.hpp"

namespace armature {

void Dispatcher::accept(const Home& home) noexcept {
  std::optional<MoveRefused> refusal = find_refusal(robot_, home);
  if (!refusal && !rest()) refusal = MoveRefused{.reason = Refusal::kNotReady};
  if (refusal) {
    refusal->tag = home.tag;
    return events_.on_event(*refusal);
  }
  const auto all = static_cast<std::uint8_t>((1u << robot_.axis_count) - 1u);
  [[maybe_unused]] const bool pushed =
      mailbox_.homings.try_push({.axes = home.axes == 0 ? all : home.axes, .tag = home.tag});
  assert(pushed);  // the one before was answered
  homing_ = true;
  mode_ = Mode::kAwaitingRest;
}

void Dispatcher::end_homing() noexcept {
  if (!homing_) return;
  homing_ = false;
  [[maybe_unused]] const bool pushed = mailbox_.homings.try_push({});
  assert(pushed);  // beside the request at most
}

void Dispatcher::on_referenced(std::uint8_t axes) noexcept {
  const std::uint32_t all = (1u << robot_.axis_count) - 1u;
  homing_ = false;
  referenced_ = (axes & all) == all;
  if (!referenced_) drop_moves(Refusal::kNotReferenced);
}

}  // namespace armature
