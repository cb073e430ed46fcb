// The source of set-points that executes the plans of core 1 and obeys stops, holds and overrides.
//
// A hold brakes on the path and stands there; when it is released, the present plan and the waiting ones continue.
// During a hold no plan begins, not even if the present one ends within the braking distance. A stop drops all plans,
// brakes on the path and ends where the arm then stands. Hold, resume, override and a soft stop keep the limits of the
// present move, including those of the tool and of jerk. A quick stop is protective: it uses the full acceleration of
// the joints on the path, whatever the move's own limits, and its jerk is not limited. An override applies to all plans
// until the next one.
//
// A plan that continues the active one replaces it at a time at which both are the same, at any rate. If it comes too
// late, it is dropped, and the active plan ends in its stop.
//
// A RetargetRequest is planned here, from the state of motion a few ticks later (retarget_in_motion.hpp). Until then
// the active plan goes on, and no other one begins or continues it. The new move replaces it: its moves are cut short,
// and the waiting ones are dropped. If a joint would leave its limits on the way, it is refused, and the active plan
// continues. A hold that comes while it is planned holds the new move; a stop ends the active plan, and takes effect up
// to 3 ticks later.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/activity/activity_source.hpp"
#include "controller/activity/channel.hpp"
#include "controller/activity/plans/move_progress.hpp"
#include "controller/activity/plans/path_pins.hpp"
#include "controller/activity/plans/retarget_in_motion.hpp"
#include "controller/activity/plans/retarget_request.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/event.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/run/read_ahead.hpp"
#include "controller/trajectory/run/sampler.hpp"

namespace armature {

class PlanSource final : public ActivitySource {
 public:
  // References must outlive the runner.
  PlanSource(const RobotModel& robot, const Arm& arm, Channel& channel, EventListener& events) noexcept;
  PlanSource(const PlanSource&) = delete;
  PlanSource& operator=(const PlanSource&) = delete;

  // ActivitySource, the one that has the arm by default. A request is a RetargetRequest; the plans are in PlanStore.
  void begin(const Request&, const PerAxis<Radians>&, Ticks) noexcept override {}
  void feed(const Request& next) noexcept override { retarget_ = next.get<RetargetRequest>(); }
  void stop(StopKind how) noexcept override;
  SetPoint& advance(Ticks tick, const RunControl::View& control) noexcept override;
  [[nodiscard]] bool over() noexcept override { return false; }
  void reset_to(const PerAxis<Radians>& position) noexcept override;
  void cut_short(Ticks tick) noexcept override;
  // Also reports plans that have not started as refused, move by move.
  void cancel(Ticks tick) noexcept override;
  void drop(const Request& request) noexcept override;

  // No plan is under way.
  [[nodiscard]] bool at_rest() const noexcept { return !under_way_; }

 private:
  [[nodiscard]] bool count_plans_over() noexcept;
  void accept_stop() noexcept;
  void brake() noexcept;
  void retarget(const RetargetRequest& request, Ticks tick) noexcept;
  [[nodiscard]] bool start_retarget(const RetargetRequest& request, Ticks tick) noexcept;
  void begin_plans(Ticks tick, const RunControl::View& control) noexcept;
  void start_next_plan(double share) noexcept;
  void continue_with_next() noexcept;
  void take_next_plan() noexcept;
  void drop_next_plan() noexcept;
  void release_plan() noexcept;
  [[nodiscard]] bool a_move_starts() const noexcept;
  void report_progress(const StepsAhead::Step& step, Ticks tick) noexcept;
  [[nodiscard]] MotionState state_of_motion(bool hold, bool moved) const noexcept;
  void drop_plans(Refusal reason) noexcept;
  void drop_all() noexcept;
  void refuse_retarget(const RetargetRequest& request) noexcept;
  void end_plan(Ticks tick, Refusal reason) noexcept;
  void cancel_plan(Ticks tick) noexcept;

  const RobotModel& robot_;
  PlanStore& store_;
  LoopChannel& loop_;
  EventListener& events_;
  Sampler sampler_;
  RetargetInMotion in_motion_;
  ReadAhead read_ahead_;
  PathPins pins_;
  bool under_way_ = false;  // sampler_ has a plan that is neither finished nor cancelled
  // PieceStores of the plan of sampler_ and of those that were dropped behind it; 0: it came from no queue.
  std::size_t stores_held_ = 0;
  std::optional<StopKind> stop_{};  // to begin with
  bool stopping_ = false;
  bool soft_ = false;                          // within the limits of the move
  std::optional<RetargetRequest> retarget_{};  // to begin with, or being planned
  std::uint32_t plans_taken_ = 0;              // number of plans that have left the queue
  std::uint32_t number_ = 0;                   // of the active plan, as in PlanProgress
  std::uint32_t plans_late_ = 0;               // as PlanStore::late
  MoveProgress progress_;                      // of the active plan
  std::uint32_t plans_ended_ = 0;              // number of plans that ended or were dropped
  std::uint32_t plans_pulsing_ = 0;  // those of them that ended before the latest tick: their last set is being emitted
};

}  // namespace armature
