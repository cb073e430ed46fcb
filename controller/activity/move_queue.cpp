#include "controller/activity/move_queue.hpp"

#include <utility>

namespace armature {

const MoveQueue::Move* MoveQueue::front() const noexcept {
  const Waiting* waiting = waiting_.front();
  return waiting != nullptr ? &waiting->move : nullptr;
}

const MoveQueue::Move* MoveQueue::next() const noexcept {
  const Waiting* waiting = waiting_.front();
  return waiting != nullptr && waiting->follows ? &waiting->move : nullptr;
}

// Not inlined: g++ 12 would take the other members of the variant for read.
[[gnu::noinline]] bool MoveQueue::push(const Move& move) noexcept {
  return waiting_.try_push({.move = move, .follows = !std::exchange(gap_, false), .replacing = replacing_});
}

void MoveQueue::refuse_front(Refusal why) noexcept {
  events_.on_event(refused(why, std::visit([](const auto& move) { return move.tag; }, *front())));
  waiting_.drop_front();
}

void MoveQueue::refuse_all(Refusal why) noexcept {
  while (!empty()) refuse_front(why);
}

void MoveQueue::drop(Refusal why) noexcept {
  while (const Waiting* waiting = waiting_.front()) {
    const bool after = static_cast<std::int32_t>(waiting->replacing - replaced_by_) >= 0;
    if (why == Refusal::kReplaced && after) return;
    refuse_front(why);
  }
}

}  // namespace armature
