// Passes the set-points of a stream on to core 0: checks them, and converts poses of the tool to joints.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/cell/planning_config.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/command.hpp"
#include "controller/message/move_refused.hpp"
#include "controller/motion/mailbox.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class StreamFeed {
 public:
  // References must outlive the feed.
  StreamFeed(const RobotModel& robot, const Arm& arm, const PlanningConfig& config, MotionMailbox& mailbox) noexcept
      : robot_{robot}, arm_{arm}, config_{config}, mailbox_{mailbox} {}

  // Core 0 follows a stream, as far as core 1 knows.
  [[nodiscard]] bool active() const noexcept { return active_; }
  // True for a set-point of the active stream that comes before its last one and before a stop.
  [[nodiscard]] bool expects(const StreamPoint& point) const noexcept {
    return active_ && !closed_ && !point.first && point.tag == tag_;
  }

  // Sends a first or an expected set-point to core 0, or returns why not. A stream with a refused set-point stops.
  // `stand`: where the arm stands, for the first one.
  [[nodiscard]] std::optional<MoveRefused> send(const StreamPoint& point, const PerAxis<Radians>& stand) noexcept;
  // kStop or kQuickStop. No effect after one that is not weaker.
  void stop(StreamSample::Kind how) noexcept;
  // Core 0 has reported that the arm stands, or a fault.
  void ended() noexcept { active_ = false; }
  // Inverse kinematics computed since the last call.
  [[nodiscard]] std::int64_t take_inverses() noexcept;

 private:
  [[nodiscard]] std::optional<MoveRefused> find_refusal(const StreamPoint& point) const noexcept;
  [[nodiscard]] std::optional<MoveRefused> solve(const StreamPoint& point) noexcept;

  const RobotModel& robot_;
  const Arm& arm_;
  const PlanningConfig& config_;
  MotionMailbox& mailbox_;
  PerAxis<Radians> joints_{};  // of the latest set-point
  Ticks time_{};               // likewise
  Tag tag_{};
  bool active_ = false;
  bool closed_ = false;
  StreamSample::Kind stopped_ = StreamSample::Kind::kFirst;  // how it was stopped; kFirst: it was not
  std::int64_t inverses_ = 0;
};

}  // namespace armature
