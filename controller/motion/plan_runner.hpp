// Runs through the plans that core 1 sends, one set-point a tick, and obeys stops, holds and overrides.
//
// A hold brakes on the path and stands there; what is under way and what waits goes on when it is released. While it is
// on no plan begins, neither after the one under way, which may end within the braking, nor from rest. A stop drops
// everything, brakes on the path and ends where it then stands. Hold, resume and override keep the limits of the move
// under way, those of the tool and of jerk included. A stop is protective: it brakes with all that the joints'
// accelerations allow on the path, whatever the move's own limits, and its jerk is not limited. An override applies to
// all plans until the next one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/event/event.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/motion/mailbox.hpp"
#include "controller/motion/telemetry.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/run/sampler.hpp"

namespace armature {

class PlanRunner {
 public:
  struct Outcome {
    MotionState state = MotionState::kIdle;
    bool at_rest = false;       // a stop is complete: core 1 waits to hear it
    bool plan_taken = false;    // there is room for another one
    bool wake = false;          // core 1 waits for this tick, or a plan is over, see MotionMailbox
    std::int64_t inverses = 0;  // inverse kinematics computed in this tick
  };

  // References must outlive the runner.
  PlanRunner(const RobotModel& robot, const Arm& arm, MotionMailbox& mailbox, EventListener& events) noexcept;
  PlanRunner(const PlanRunner&) = delete;
  PlanRunner& operator=(const PlanRunner&) = delete;

  // One tick: position() is then the next set-point. Not in Fault.
  Outcome advance(Ticks tick) noexcept;

  // Gives up what it does and stands at `position`.
  void stand_at(const PerAxis<Radians>& position) noexcept;

  // A fault begins: the moves that have started are reported as cut short.
  void cut_short(Ticks tick) noexcept;
  // In Fault: gives up the plan under way and drops all that wait. Moves that have not started are reported as refused.
  void abandon(Ticks tick) noexcept;

  [[nodiscard]] const PerAxis<Radians>& position() const noexcept { return sampler_.position(); }
  [[nodiscard]] double rate() const noexcept { return sampler_.rate(); }

 private:
  [[nodiscard]] bool count_plans_over() noexcept;
  void take_order(Outcome& outcome) noexcept;
  void start_next_plan(double share, Outcome& outcome) noexcept;
  void report_progress(Ticks tick) noexcept;
  void drop_plans() noexcept;
  void finish_move(MoveFinished::How how, Ticks tick, Ticks taken) noexcept;
  void give_up_plan(Ticks tick) noexcept;

  MotionMailbox& mailbox_;
  EventListener& events_;
  Sampler sampler_;
  bool under_way_ = false;  // sampler_ has a plan that is neither finished nor given up
  bool stopping_ = false;
  std::size_t begun_ = 0;     // moves of the plan under way that have been reported as started
  std::size_t finished_ = 0;  // those of them that have been reported as finished
  std::array<Ticks, CartesianPlan::kMostSegments> started_at_{};  // of the moves of the plan under way
  std::uint32_t plans_ended_ = 0;                                 // or dropped
  std::uint32_t plans_pulsing_ = 0;  // those of them before the latest tick: their last set has started
};

}  // namespace armature
