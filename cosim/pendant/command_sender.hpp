// The pendant's end of the commands: sends one, repeats it until its reply comes, and counts the sequence.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "controller/pendant/protocol/frame.hpp"

namespace armature::cosim {

// What a pendant repeats while it is pressed or connected.
inline constexpr std::chrono::microseconds kEstopEvery{50'000}, kHeartbeatEvery{100'000};

class CommandSender {
 public:
  using Time = std::chrono::microseconds;  // since any moment; a caller chooses the clock
  static constexpr Time kRepeatAfter{20'000};
  static constexpr int kRepeats = 3;
  static constexpr int kCommitFactor = 10;  // program_commit is answered when the program is loaded

  // `repeat_after`: more than kRepeatAfter where the controller is simulated, and its time passes slower.
  explicit CommandSender(Time repeat_after = kRepeatAfter) : repeat_after_{repeat_after} {}

  // Begins to send a command; its sequence number is set here. Call it only while idle(). Returns the bytes to send.
  [[nodiscard]] pendant::FrameBytes send(pendant::Frame command, Time now);

  // The bytes to send again, when it is time. The command is given up when its repetitions have had no reply: then the
  // pendant does not know whether it was executed, and begins a new session.
  [[nodiscard]] std::optional<pendant::FrameBytes> poll(Time now);

  // True when this is the reply to the command that was sent last.
  bool on_reply(const pendant::Frame& reply);

  // When poll() must be called next; none while idle().
  [[nodiscard]] std::optional<Time> due() const { return waiting_ ? std::optional{due_} : std::nullopt; }
  [[nodiscard]] bool idle() const { return !waiting_; }
  // The last command was given up.
  [[nodiscard]] bool lost() const { return lost_; }
  // Number of frames that were sent again, since the start.
  [[nodiscard]] std::int64_t repeated() const { return repeated_; }

 private:
  [[nodiscard]] Time patience() const;

  Time repeat_after_;
  pendant::Frame command_{};
  std::uint8_t next_sequence_ = 0;
  bool waiting_ = false;
  bool lost_ = false;
  int repeats_left_ = 0;
  Time due_{};
  std::int64_t repeated_ = 0;
};

}  // namespace armature::cosim
