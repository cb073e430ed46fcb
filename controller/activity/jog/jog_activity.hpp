// Jogs on core 1. A jog is no plan: its commands go to core 0 at once, the latest of each execute(), and moves wait
// until core 0 reports where the arm stands after the jog.
#pragma once

#include <optional>

#include "controller/activity/activity.hpp"
#include "controller/activity/activity_context.hpp"
#include "controller/activity/jog/velocity_input.hpp"
#include "controller/message/command.hpp"
#include "controller/message/move_refused.hpp"

namespace armature {

class JogActivity final : public Activity {
 public:
  explicit JogActivity(const ActivityContext& context) noexcept : context_{context} {}

  [[nodiscard]] std::optional<MoveRefused> accept(const Jog& jog) noexcept;
  // Call at the end of each execute().
  void send() noexcept;

  // Activity. A command that was not sent is dropped without a report.
  void on_stop(StopKind) noexcept override { next_.reset(); }
  void drop(Refusal) noexcept override { next_.reset(); }

 private:
  ActivityContext context_;
  std::optional<VelocityCommand> next_{};  // to be sent
};

}  // namespace armature
