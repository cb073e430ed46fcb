// Core 0: the 50 us tick. It reads encoder positions, reacts to faults and commits set-points.
//
// Tick k: the trigger starts the counts committed in tick k-1 and latches the positions; this loop then computes and
// commits the counts of tick k+1 before the next trigger.
//
// A late tick loses no pulse and moves no axis. A trigger without a commit emits nothing (the logic counts an
// underrun). While a set still waits for its trigger, nothing new is committed and the set-point does not change. The
// path is executed later, not faster. On the logic of Vo 2021 the axes continue with their old speed when the core is
// late; the excess is corrected later (paper_logic_port.hpp).
//
// A late core does not wait for the trigger. So a long wait means that the logic stood still, clock or timer: all pins
// kept their levels meanwhile, and an emergency stop had no effect. The loop reports this when it continues (kClock).
// If the core waited for the bus then, only the time since the trigger before shows it: it is longer than the ticks
// that the logic has counted. The same fault says that a tick is not as long as it should be.
//
// States: Idle <-> Moving <-> Holding, both -> Stopping -> Idle; each -> Fault -> Idle (Order::kClearFault). In
// Fault empty sets are committed and the drives are off. An axis whose encoder was at fault, or has left the motion of
// its drive, is not referenced any more: its position may be false. The source of set-points (motion_source.hpp)
// determines the motion.
#pragma once

#include "controller/base/axes.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/message/telemetry.hpp"
#include "controller/motion/axis_control.hpp"
#include "controller/motion/controller_observer.hpp"
#include "controller/motion/cordic/inverse_check.hpp"
#include "controller/motion/emission.hpp"
#include "controller/motion/logic_port.hpp"
#include "controller/motion/loop_channel.hpp"
#include "controller/motion/set_point_source.hpp"
#include "controller/motion/tick_time.hpp"
#include "controller/robot/encoder_monitor.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class MotionLoop {
 public:
  // References must outlive the loop; `logic` is on `bus`. `feedback`: encoder feedback corrects the commanded pulses;
  // it requires that every encoder is always counted. `referenced`: the joint angles are 0 at the start; otherwise they
  // are not known. `inverse`: what the solver of `source` has done, if it is not software.
  MotionLoop(const RobotModel& robot, bool feedback, LogicPort& logic, RegisterBus& bus, LoopChannel& channel,
             SetPointSource& source, ControllerObserver& observer, bool referenced = true,
             InverseCheck* inverse = nullptr) noexcept;
  MotionLoop(const MotionLoop&) = delete;
  MotionLoop& operator=(const MotionLoop&) = delete;

  // The main of core 0: starts the logic and executes the tick until the core is switched off.
  void run() noexcept;

 private:
  struct Finding {
    FaultCause cause = FaultCause::kNone;
    std::uint8_t axis = 0;  // as in Telemetry
  };

  void start() noexcept;
  void tick() noexcept;
  void account_for_emission(const LogicInput& input) noexcept;
  [[nodiscard]] Finding find_fault(const LogicInput& input) const noexcept;
  [[nodiscard]] Finding find_axis_fault(const LogicInput& input) const noexcept;
  [[nodiscard]] std::uint8_t uncounted_motion(const LogicInput& input) const noexcept;
  [[nodiscard]] std::uint8_t untrusted_axes(const LogicInput& input) const noexcept;

  void follow_source(const LogicInput& input) noexcept;
  void judge_deviation(const LogicInput& input) noexcept;
  void shift_positions(const SetPoint& located) noexcept;

  void enter_fault(const Finding& finding) noexcept;
  void tick_in_fault(const LogicInput& input) noexcept;
  [[nodiscard]] bool fault_can_end(const LogicInput& input) const noexcept;
  void update_standstill(const PerAxis<Counts>& encoder) noexcept;
  void restart_axes() noexcept;
  void reset_source() noexcept;
  [[nodiscard]] Counts standstill_position(std::size_t axis, Pulses emitted) const noexcept;

  void answer(Answer::Kind kind) noexcept;
  void report_fault() noexcept;
  void update_telemetry(const LogicInput& input) noexcept;

  const RobotModel& robot_;
  RegisterBus& bus_;
  LoopChannel& channel_;
  ControllerObserver& observer_;
  LogicPort& logic_;
  PerAxis<AxisControl> axes_;
  std::size_t judged_ = 0;           // the axis whose deviation is judged next
  std::uint8_t deviating_axis_ = 0;  // 1..6: that of the axis judged last is too large; 0: it is not
  Emission emission_;
  SetPointSource& source_;
  InverseCheck* inverse_;
  Telemetry telemetry_{};
  std::uint8_t referenced_;  // mask of axes whose joint angles are known
  EncoderMonitor monitor_;
  Core1Watch watch_;
  TickTime time_;
  bool clearing_ = false;  // in Fault: the latches were cleared, the result is known in the next tick
  PerAxis<Counts> still_position_{};
  Ticks still_{};
};

}  // namespace armature
