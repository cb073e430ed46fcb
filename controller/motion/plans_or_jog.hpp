// The source of set-points of the controller: the plans of core 1, or a jog while the arm has none.
//
// A jog begins with the first jog command, which core 1 sends only when the arm stands at the end of all plans. It ends
// when no command wants motion and the last pulse is emitted; core 1 is then notified of the position, as after a stop.
// Both are reported as events.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/event.hpp"
#include "controller/motion/jog_input.hpp"
#include "controller/motion/mailbox.hpp"
#include "controller/motion/motion_source.hpp"
#include "controller/motion/plan_runner.hpp"
#include "controller/motion/velocity_source.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class PlansOrJog final : public MotionSource {
 public:
  // References must outlive the source.
  PlansOrJog(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool, MotionMailbox& mailbox,
             EventListener& events) noexcept;
  PlansOrJog(const PlansOrJog&) = delete;
  PlansOrJog& operator=(const PlansOrJog&) = delete;

  // MotionSource
  const SetPoint& advance(Ticks tick) noexcept override;
  void reset_to(const PerAxis<Radians>& position) noexcept override;
  void cut_short(Ticks tick) noexcept override;
  void cancel(Ticks tick) noexcept override;
  [[nodiscard]] Stopping stopping() const noexcept override;

 private:
  void begin_jog(Ticks tick) noexcept;
  void jog(Ticks tick) noexcept;
  void report_end(VelocitySource::Ending ending, Ticks last) noexcept;

  MotionMailbox& mailbox_;
  EventListener& events_;
  JogInput input_;
  PlanRunner plans_;
  VelocitySource velocity_;
  bool jogging_ = false;
  int still_ticks_ = 0;                  // ticks at rest without a command, of this jog
  std::optional<JogStarted> started_{};  // of the jog that is reported as started and not as ended
  std::uint32_t commands_before_ = 0;    // MotionMailbox::jogs_accepted when it began
  Ticks last_step_{};                    // the latest tick with motion
};

}  // namespace armature
