// The source of set-points of the controller: plans, a jog, or a stream of set-points, a part on the conveyor or homing
// while the arm has neither.
//
// A stream begins with its first set-point, a part is followed from its first request on, and homing begins with its
// request. Core 1 sends all three only when the arm stands at the end of all plans. When it is over, core 1 is notified
// of the position, as after a stop.
#pragma once

#include <optional>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/event.hpp"
#include "controller/motion/conveyor_source.hpp"
#include "controller/motion/homing_source.hpp"
#include "controller/motion/logic_port.hpp"
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
             EventListener& events, LogicPort& logic, const ConveyorConfig* conveyor = nullptr,
             BeltEncoder* encoder = nullptr) noexcept;
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
  void read_homing() noexcept;
  const SetPoint& home(Ticks tick) noexcept;
  const SetPoint& follow_part(Ticks tick) noexcept;

  MotionMailbox& mailbox_;
  EventListener& events_;
  PlansOrJog others_;
  StreamSource stream_;
  bool streaming_ = false;
  HomingSource homing_;
  std::optional<ConveyorSource> conveyor_{};
  bool following_ = false;  // a part, or waiting for it
};

}  // namespace armature
