// A snapshot of this process: a copy that waits, and continues from there when it is woken. This process continues,
// too.
//
//   auto taken = take_snapshot();
//   if (auto* woken = std::get_if<WokenCopy>(&taken)) {  // in the copy, later
//     const auto order = woken->order<Order>();
//     ...
//     woken->end(answer);
//   }
//   auto& snapshot = std::get<WaitingCopy>(taken);
//   ...
//   snapshot.wake(order);
//   const auto answer = snapshot.answer<Answer>();
//
// A copy ends when this process ends, however that happens; see copied_process.hpp.
#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>
#include <utility>
#include <variant>

#include "cosim/snapshot/message_channel.hpp"

namespace armature::cosim {

class WaitingCopy {
 public:
  WaitingCopy(pid_t process, MessageChannel channel) : process_{process}, channel_{std::move(channel)} {}
  WaitingCopy(WaitingCopy&& other) noexcept
      : process_{std::exchange(other.process_, 0)}, channel_{std::move(other.channel_)} {}
  WaitingCopy& operator=(WaitingCopy&&) = delete;
  // Ends the copy and waits for that, which takes less time some while after end().
  ~WaitingCopy();

  // Call it once. Returns false when the copy does not exist any more.
  template <class Order>
  bool wake(const Order& order) {
    return channel_.send(order);
  }
  // Waits for the answer of the copy. Nothing: the copy has ended without one.
  template <class Answer>
  [[nodiscard]] std::optional<Answer> answer() {
    return channel_.receive<Answer>();
  }

  // Ends the copy.
  void end();

  [[nodiscard]] pid_t process() const { return process_; }

 private:
  pid_t process_;
  MessageChannel channel_;
};

class WokenCopy {
 public:
  explicit WokenCopy(MessageChannel channel) : channel_{std::move(channel)} {}

  // What wake() was given. Call it once.
  template <class Order>
  [[nodiscard]] Order order() {
    const std::optional<Order> order = channel_.receive<Order>();
    if (!order) ::_exit(EXIT_FAILURE);
    return *order;
  }
  // Ends the copy.
  template <class Answer>
  [[noreturn]] void end(const Answer& answer) {
    channel_.send(answer);
    ::_exit(EXIT_SUCCESS);
  }

 private:
  MessageChannel channel_;
};

// Returns a WaitingCopy in this process, and a WokenCopy in the copy when it was woken. Throws std::runtime_error as
// copy_this_process().
[[nodiscard]] std::variant<WaitingCopy, WokenCopy> take_snapshot();

}  // namespace armature::cosim
