// The planning of a long chain in windows.
//
// Its first moves are one plan, the others are plans that continue the one before while the arm executes it. So the
// moves of a chain are never planned more than a window ahead.
//
// A window is planned late, so that it has many moves, but not too late: the arm must not brake before it is there.
// PlanningCost estimates the time that its planning takes. At the start of a chain there is little time, so the first
// windows are small. Where core 1 cannot plan as fast as the tool moves, a window continues the present plan while that
// brakes already, so the tool becomes slower and does not stop. A plan that comes too late all the same does no harm:
// core 0 executes the old one to its stop, and the moves are planned again from there. The same is done with moves that
// cannot continue the plan, and it tells why if they cannot be executed at all.
//
// If the moves come too late, the arm brakes on the path, and continues from where it stops. If they came in time, but
// no plan of them did, this is a stop that nobody asked for (MoveStarted::unasked_stop).
#pragma once

#include <cstddef>
#include <cstdint>

#include "controller/activity/activity_context.hpp"
#include "controller/activity/plans/stages/path_stage.hpp"
#include "controller/activity/plans/stages/plan_outbox.hpp"
#include "controller/hal/register_bus.hpp"

namespace armature {

class WindowStage {
 public:
  // References must outlive the stage. The requests of `path` are the moves that follow.
  WindowStage(const ActivityContext& context, PathStage& path, PlanOutbox& outbox) noexcept
      : context_{context}, path_{path}, outbox_{outbox} {}

  // A plan that was sent can be continued, or one that continues it was sent.
  [[nodiscard]] bool active() const noexcept { return state_ != State::kNone; }
  [[nodiscard]] bool waits_for_time() const noexcept {
    return state_ == State::kSent || (state_ == State::kOpen && !path_.empty());
  }
  // The plan that was sent last can be continued by the moves that the path has no room for, and by those that come.
  void open() noexcept;
  // One step; false: it waits for core 0 or for moves.
  [[nodiscard]] bool work(RegisterBus& bus) noexcept;

  // A stop or a fault: reports all moves of the path that core 0 does not have as refused.
  void drop(Refusal why) noexcept;
  // Core 0 has ended both plans. If it had dropped the second one before, it has not reported the moves of that.
  void settle(Refusal why) noexcept;

 private:
  enum class State : std::uint8_t {
    kNone,
    kOpen,     // the last plan that was sent can be continued; the path has the moves that follow
    kSent,     // the plan that continues it was sent, with the first `moves_` moves of the path
    kDropped,  // the same, and a stop or a fault ends both
  };

  void collect() noexcept;
  [[nodiscard]] bool start_planning(RegisterBus& bus) noexcept;
  [[nodiscard]] bool await_start() noexcept;
  [[nodiscard]] double expected_ticks(std::size_t moves) const noexcept;
  void close() noexcept;
  void close_at_stop() noexcept;
  [[nodiscard]] bool is_braking() const noexcept;

  ActivityContext context_;
  PathStage& path_;
  PlanOutbox& outbox_;
  State state_ = State::kNone;
  std::size_t moves_ = 0;
  bool in_time_ = true;  // the first move of the path came before the arm brakes
};

}  // namespace armature
