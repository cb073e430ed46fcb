// The pendant's end of a program transfer: sends the text in bulk frames, and again from the first one that is missing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "controller/pendant/protocol/frame.hpp"
#include "cosim/pendant/command_sender.hpp"

namespace armature::cosim {

class BulkSender {
 public:
  using Time = CommandSender::Time;

  // Every character must be below 128. `repeat_after`: as for CommandSender.
  explicit BulkSender(std::string text, Time repeat_after = CommandSender::kRepeatAfter)
      : text_{std::move(text)}, repeat_after_{repeat_after} {}

  // The next frame to send; none when the window is full, until an acknowledgement or the time-out.
  [[nodiscard]] std::optional<pendant::FrameBytes> poll(Time now);
  void on_reply(const pendant::Frame& reply, Time now);

  // When poll() must be called next although nothing was received.
  [[nodiscard]] Time due(Time now) const { return window_is_full() ? due_ : now; }
  [[nodiscard]] bool complete() const { return acknowledged_ == frames(); }
  // The check value of the text, for program_commit.
  [[nodiscard]] std::int32_t check() const;
  // Number of frames that were sent again.
  [[nodiscard]] std::int64_t repeated() const { return repeated_; }

 private:
  [[nodiscard]] std::int32_t frames() const;
  [[nodiscard]] bool window_is_full() const;
  void go_back(Time now);

  std::string text_;
  Time repeat_after_;
  std::int32_t next_ = 0;          // frame
  std::int32_t acknowledged_ = 0;  // frames
  Time due_{};
  std::int64_t repeated_ = 0;
};

}  // namespace armature::cosim
