// Executes the paths of core 1 in the frame of a part on the conveyor.
//
// The arm stands until the part has come to the point where the plan begins. Then the frame of the path takes up the
// velocity of the belt while the tool executes the path, and follows the belt until core 1 releases it: between two
// paths the tool stands in the frame of the part. After a release the frame comes to rest. When the part leaves its
// window, when the belt is too fast, when a set-point is impossible, and at a stop, each joint makes its fastest stop.
//
// A set-point is executed kTicksToEmit ticks after the sample of the belt, and `lead_s` later by the drives. The frame
// is where the part is expected then.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/cell/conveyor_config.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/event.hpp"
#include "controller/motion/conveyor_belt.hpp"
#include "controller/motion/conveyor_motion.hpp"
#include "controller/motion/mailbox.hpp"
#include "controller/motion/motion_source.hpp"
#include "controller/motion/move_progress.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class ConveyorSource final : public MotionSource {
 public:
  // References must outlive the source.
  ConveyorSource(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool, const ConveyorConfig& config,
                 BeltEncoder& encoder, MotionMailbox& mailbox, EventListener& events) noexcept;
  ConveyorSource(const ConveyorSource&) = delete;
  ConveyorSource& operator=(const ConveyorSource&) = delete;

  // Samples the belt. Call once per tick, before the others.
  void sample(Ticks tick) noexcept;
  // True while a part is followed or waited for, and when a request begins that for an arm that stands at `position`.
  [[nodiscard]] bool follows(const PerAxis<Radians>& position) noexcept;
  // It is over: the arm stands, and its last pulse is emitted. Call after each advance(), while follows().
  [[nodiscard]] bool over() noexcept;

  // MotionSource
  const SetPoint& advance(Ticks tick) noexcept override;
  void reset_to(const PerAxis<Radians>& position) noexcept override;
  void cut_short(Ticks tick) noexcept override;
  void cancel(Ticks tick) noexcept override;
  [[nodiscard]] Stopping stopping() const noexcept override;

 private:
  enum class Phase : std::uint8_t { kOff, kWaiting, kFollowing, kLeaving, kStopping };

  void accept_orders(Ticks tick) noexcept;
  void begin(Ticks tick, double displacement_mm) noexcept;
  void follow(Ticks tick, const AxisState& part) noexcept;
  void report_progress(Ticks tick) noexcept;
  void end_request() noexcept;
  void end(PartEnd end, Ticks tick, std::uint8_t axis = 0) noexcept;
  void drop_request(Ticks tick, Refusal reason) noexcept;
  void brake() noexcept;
  void report(PartPhase phase, Ticks tick) noexcept;
  [[nodiscard]] AxisState part_ahead() const noexcept;

  const RobotModel& robot_;
  const ConveyorConfig& config_;
  BeltEncoder& encoder_;
  MotionMailbox& mailbox_;
  EventListener& events_;
  ConveyorBelt belt_;
  ConveyorMotion motion_;
  Phase phase_ = Phase::kOff;
  const ConveyorRequest* request_ = nullptr;  // in the mailbox, being executed
  double part_mm_ = 0.0;
  double begin_mm_ = 0.0;
  std::uint32_t session_ = 0;
  bool synchronised_ = false;
  bool request_done_ = false;  // in the last tick: its last set is being emitted
  MoveProgress progress_;      // of the plan of request_
  PartFollowed result_{};
  PerAxis<PhaseLaw> stops_{};
  std::int64_t braked_ticks_ = 0;
  int still_ticks_ = 0;
};

}  // namespace armature
