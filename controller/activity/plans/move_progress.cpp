#include "controller/activity/plans/move_progress.hpp"

#include <algorithm>

namespace armature {

void MoveProgress::continue_without(std::size_t dropped) noexcept {
  const auto first = started_at_.begin();
  std::copy(first + static_cast<std::ptrdiff_t>(finished_), first + static_cast<std::ptrdiff_t>(begun_),
            first + static_cast<std::ptrdiff_t>(finished_ - dropped));
  begun_ -= dropped;
  finished_ -= dropped;
}

void MoveProgress::finish_until(const Plan& plan, double elapsed, bool ended, Ticks tick) noexcept {
  while (finished_ < begun_) {
    const MoveSpan span = span_of(plan, finished_);
    if (!ended && static_cast<double>(span.end.value()) > elapsed) break;
    const Ticks taken = tick - started_at_[finished_] + Ticks{1};
    finish_next(plan, MoveFinished::How::kReachedEnd, tick, span.end == span.start ? Ticks{} : taken);
  }
}

void MoveProgress::finish_next(const Plan& plan, MoveFinished::How how, Ticks tick, Ticks taken) noexcept {
  events_.on_event(MoveFinished{.tag = tag_of(plan, finished_), .how = how, .tick = tick, .taken = taken});
  ++finished_;
}

void MoveProgress::cut_short(const Plan& plan, Ticks tick) noexcept {
  while (finished_ < begun_) finish_next(plan, MoveFinished::How::kCutShort, tick, tick - started_at_[finished_]);
}

void MoveProgress::drop(const Plan& plan, Ticks tick, Refusal reason) noexcept {
  cut_short(plan, tick);
  for (const std::size_t moves = moves_in(plan); begun_ < moves; ++begun_) {
    events_.on_event(dropped(plan, begun_, reason));
  }
}

}  // namespace armature
