// The moves and the commands for pins that were accepted and that nothing executes yet, in their order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "controller/activity/activity.hpp"
#include "controller/base/spsc_queue.hpp"
#include "controller/message/command.hpp"
#include "controller/message/event.hpp"
#include "controller/message/inbox.hpp"

namespace armature {

class MoveQueue final : public Activity {
 public:
  static constexpr std::size_t kMoves = 16;
  using Move = std::variant<JointMove, PoseMove, CartesianMove, Dwell, SetOutput, WaitInput>;

  // References must outlive the queue. The moves of programs wait in `program` until there is room.
  MoveQueue(const Inbox& program, EventListener& events) noexcept : program_{program}, events_{events} {}

  [[nodiscard]] bool empty() const noexcept { return waiting_.empty(); }
  [[nodiscard]] bool full() const noexcept { return waiting_.full(); }
  // Further moves wait, here or in the inbox of programs.
  [[nodiscard]] bool more_wait() const noexcept { return !empty() || !program_.empty(); }
  // The first move, or null.
  [[nodiscard]] const Move* front() const noexcept;
  // The first move if it continues the one before it, otherwise null: no move was refused between the two, and none
  // begins at once.
  [[nodiscard]] const Move* next() const noexcept;
  template <class M>
  [[nodiscard]] const M* next_if() const noexcept {
    const Move* move = next();
    return move != nullptr ? std::get_if<M>(move) : nullptr;
  }

  // False: there is no room.
  [[nodiscard]] bool push(const Move& move) noexcept;
  // The next move does not continue the last one.
  void break_chain() noexcept { gap_ = true; }
  void drop_front() noexcept { waiting_.drop_front(); }
  void refuse_front(Refusal why) noexcept;
  void refuse_all(Refusal why) noexcept;

  // Moves that come after this are not replaced by the joint move that begins at once. Returns the number of such moves
  // so far; wraps.
  std::uint32_t count_replacing() noexcept { return ++replacing_; }
  // The next drop for kReplaced is caused by the joint move with this number.
  void set_replaced_by(std::uint32_t number) noexcept { replaced_by_ = number; }

  // Activity
  [[nodiscard]] bool idle() const noexcept override { return empty(); }
  void drop(Refusal why) noexcept override;

 private:
  struct Waiting {
    Move move;
    bool follows = false;         // no move was refused between it and the previously accepted one
    std::uint32_t replacing = 0;  // value of replacing_ when it came
  };

  const Inbox& program_;
  EventListener& events_;
  SpscQueue<Waiting, kMoves> waiting_;
  bool gap_ = false;
  std::uint32_t replacing_ = 0;
  std::uint32_t replaced_by_ = 0;
};

template <class M>
concept QueuedMove = std::is_constructible_v<MoveQueue::Move, M>;

}  // namespace armature
