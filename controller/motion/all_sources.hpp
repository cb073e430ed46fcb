// The source of set-points of the controller: plans, a jog, or a stream of set-points or a part on the conveyor while
// the arm has neither.
//
// A stream begins with its first set-point, and a part is followed from its first request on. Core 1 sends both only
// when the arm stands at the end of all plans. When it is over, core 1 is notified of the position, as after a stop.
#pragma once

#include <optional>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/event/event.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/motion/conveyor_source.hpp"
#include "controller/motion/mailbox.hpp"
#include "controller/motion/motion_source.hpp"
#include "controller/motion/plans_or_jog.hpp"
#include "controller/motion/stream_source.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class AllSources final : public MotionSource {
 public:
  // References must outlive the source. `conveyor` and its encoder: none without a conveyor.
  AllSources(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool, MotionMailbox& mailbox,
             EventListener& events, const ConveyorConfig* conveyor = nullptr, BeltEncoder* encoder = nullptr) noexcept;
  AllSources(const AllSources&) = delete;
  AllSources& operator=(const AllSources&) = delete;

  // MotionSource
  const SetPoint& advance(Ticks tick) noexcept override;
  void reset_to(const PerAxis<Radians>& position) noexcept override;
  void cut_short(Ticks tick) noexcept override;
  void cancel(Ticks tick) noexcept override;
  [[nodiscard]] Stopping stopping() const noexcept override;

 private:
  void read_stream(Ticks tick) noexcept;
  const SetPoint& follow_part(Ticks tick) noexcept;

  MotionMailbox& mailbox_;
  EventListener& events_;
  PlansOrJog others_;
  StreamSource stream_;
  bool streaming_ = false;
  std::optional<ConveyorSource> conveyor_{};
  bool following_ = false;  // a part, or waiting for it
};

}  // namespace armature
