// Streams on core 1: checks the set-points, converts poses of the tool to joints, and sends them to core 0 at once.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/activity/activity.hpp"
#include "controller/activity/activity_context.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/message/command.hpp"
#include "controller/message/move_refused.hpp"

namespace armature {

class StreamActivity final : public Activity {
 public:
  explicit StreamActivity(const ActivityContext& context) noexcept : context_{context} {}

  // A stream with a refused set-point stops. Set-points that come later have no effect.
  [[nodiscard]] std::optional<MoveRefused> accept(const StreamPoint& point) noexcept;
  // Inverse kinematics computed since the last call.
  [[nodiscard]] std::int64_t take_inverses() noexcept;

  // Activity
  void on_stop(StopKind) noexcept override { closed_ = true; }
  void on_rest() noexcept override { active_ = false; }

 private:
  // Comes before the last set-point of the active stream, and before a stop.
  [[nodiscard]] bool expects(const StreamPoint& point) const noexcept {
    return active_ && !closed_ && !point.first && point.tag == tag_;
  }
  [[nodiscard]] std::optional<MoveRefused> send(const StreamPoint& point) noexcept;
  [[nodiscard]] std::optional<MoveRefused> find_refusal(const StreamPoint& point) const noexcept;
  [[nodiscard]] std::optional<MoveRefused> solve(const StreamPoint& point) noexcept;

  ActivityContext context_;
  PerAxis<Radians> joints_{};  // of the latest set-point
  Ticks time_{};               // likewise
  Tag tag_{};
  bool active_ = false;  // core 0 follows the stream, as far as core 1 knows
  bool closed_ = false;
  std::int64_t inverses_ = 0;
};

}  // namespace armature
