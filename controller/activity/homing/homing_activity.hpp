// Homing on core 1: sends the request to core 0. From then on the joint angles of the axes are not known, see ArmOwner.
#pragma once

#include <optional>

#include "controller/activity/activity.hpp"
#include "controller/activity/activity_context.hpp"
#include "controller/message/command.hpp"
#include "controller/message/move_refused.hpp"

namespace armature {

class HomingActivity final : public Activity {
 public:
  explicit HomingActivity(const ActivityContext& context) noexcept : context_{context} {}

  [[nodiscard]] std::optional<MoveRefused> accept(const Home& home) noexcept;

 private:
  ActivityContext context_;
};

}  // namespace armature
