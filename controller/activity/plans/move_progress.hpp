// Reports which moves of the active plan have started and finished.
//
// A move begins in the tick of its first step, and ends in that of its last. Moves finish in the order in which they
// start.
#pragma once

#include <array>
#include <cstddef>

#include "controller/activity/plans/move_events.hpp"
#include "controller/base/units.hpp"
#include "controller/message/event.hpp"
#include "controller/trajectory/plan/plan.hpp"

namespace armature {

class MoveProgress {
 public:
  // `events` must outlive the object.
  explicit MoveProgress(EventListener& events) noexcept : events_{events} {}

  // A plan begins: none of its moves has started.
  void begin() noexcept { begun_ = finished_ = 0; }
  // A plan begins that continues the active one. `dropped`: moves of the active one, all finished, that it lacks.
  void continue_without(std::size_t dropped) noexcept;

  // Reports the moves that have started or finished when `elapsed` ticks of the plan are over; all of them, if it has
  // `ended`. `adjust(MoveStarted&)` may change the event of a start.
  template <typename Adjust>
  void advance(const Plan& plan, double elapsed, bool ended, Ticks tick, Adjust adjust) noexcept {
    for (const std::size_t moves = moves_in(plan); begun_ < moves; ++begun_) {
      if (!ended && !(static_cast<double>(span_of(plan, begun_).start.value()) < elapsed)) break;
      started_at_[begun_] = tick;
      MoveStarted event = started(plan, begun_, tick);
      adjust(event);
      events_.on_event(event);
    }
    finish_until(plan, elapsed, ended, tick);
  }
  void advance(const Plan& plan, double elapsed, bool ended, Ticks tick) noexcept {
    advance(plan, elapsed, ended, tick, [](MoveStarted&) {});
  }

  // Another move than the first one starts before that time.
  [[nodiscard]] bool starts_before(const Plan& plan, double elapsed) const noexcept {
    return begun_ > 0 && begun_ < moves_in(plan) && static_cast<double>(span_of(plan, begun_).start.value()) < elapsed;
  }
  // Reports the moves that are under way as cut short.
  void cut_short(const Plan& plan, Ticks tick) noexcept;
  // The same, and reports the moves that have not started as refused for `reason`.
  void drop(const Plan& plan, Ticks tick, Refusal reason) noexcept;

 private:
  void finish_until(const Plan& plan, double elapsed, bool ended, Ticks tick) noexcept;
  void finish_next(const Plan& plan, MoveFinished::How how, Ticks tick, Ticks taken) noexcept;

  EventListener& events_;
  std::size_t begun_ = 0;     // moves that have been reported as started
  std::size_t finished_ = 0;  // those of them that have been reported as finished
  std::array<Ticks, CartesianPlan::kMaxSegments> started_at_{};
};

}  // namespace armature
