// The controller's end of the commands: which of them to execute, and the replies.
//
// The pendant repeats a command until it has the reply. So the link keeps the last command and its reply. A repeated
// command is never executed again: it gets the same reply, or none as long as there is none.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/pendant/protocol/frame.hpp"

namespace armature::pendant {

class CommandLink {
 public:
  struct Decision {
    bool execute = false;          // the caller calls answer() once, now or later
    std::optional<Frame> reply{};  // to send now
  };

  // A command has come. While an answer is outstanding no other command is executed: its reply is kBadSequence with its
  // own number, and the pendant sends it again later.
  [[nodiscard]] Decision on_command(const Frame& command) noexcept;

  // The reply to the command that was executed. None when a new session has begun meanwhile: nobody waits for it.
  [[nodiscard]] std::optional<Frame> answer(Status status, std::int32_t payload = 0) noexcept;

  // A command that was executed waits for its answer.
  [[nodiscard]] bool outstanding() const noexcept { return outstanding_; }

 private:
  [[nodiscard]] Decision begin_session(const Frame& command) noexcept;

  std::optional<std::int32_t> session_{};  // number of the present session
  std::uint8_t expected_ = 0;              // sequence number of the next command
  bool outstanding_ = false;
  std::optional<Frame> last_{};   // executed last, or being executed
  std::optional<Frame> reply_{};  // to it
};

// A heartbeat with this parameter begins a session.
inline constexpr auto kBeginSession = static_cast<std::uint8_t>(HeartbeatKind::kBeginSession);
[[nodiscard]] constexpr bool begins_session(const Frame& command) noexcept {
  return command.opcode == Opcode::kHeartbeat && command.parameter == kBeginSession;
}

}  // namespace armature::pendant
