#include "controller/pendant/protocol/command_link.hpp"

namespace armature::pendant {
namespace {

Frame reply_to(const Frame& command, Status status, std::int32_t payload) {
  return {.kind = Kind::kReply,
          .sequence = command.sequence,
          .opcode = command.opcode,
          .parameter = static_cast<std::uint8_t>(status),
          .payload = payload};
}

}  // namespace

CommandLink::Decision CommandLink::on_command(const Frame& command) noexcept {
  if (last_ && command == *last_) return {.reply = reply_};
  if (begins_session(command)) return begin_session(command);
  if (!session_) return {.reply = reply_to(command, Status::kBadSequence, -1)};
  if (outstanding_ || command.sequence != expected_) {
    return {.reply = reply_to(command, Status::kBadSequence, expected_)};
  }
  last_ = command;
  reply_.reset();
  outstanding_ = true;
  expected_ = after(expected_);
  return {.execute = true};
}

// A late repetition of the beginning must not make old commands valid again. So a session begins only once.
CommandLink::Decision CommandLink::begin_session(const Frame& command) noexcept {
  if (session_ == command.payload) return {.reply = reply_to(command, Status::kOk, command.payload)};
  session_ = command.payload;
  last_ = command;
  reply_ = reply_to(command, Status::kOk, command.payload);
  expected_ = after(command.sequence);
  return {.reply = reply_};
}

std::optional<Frame> CommandLink::answer(Status status, std::int32_t payload) noexcept {
  outstanding_ = false;
  if (!last_ || reply_) return std::nullopt;
  reply_ = reply_to(*last_, status, payload);
  return reply_;
}

}  // namespace armature::pendant
