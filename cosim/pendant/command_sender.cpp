#include "cosim/pendant/command_sender.hpp"

namespace armature::cosim {

pendant::FrameBytes CommandSender::send(pendant::Frame command, Time now) {
  command.kind = pendant::Kind::kCommand;
  command.sequence = next_sequence_;
  next_sequence_ = pendant::after(next_sequence_);
  command_ = command;
  waiting_ = true;
  lost_ = false;
  repeats_left_ = kRepeats;
  due_ = now + patience();
  return encode(command_);
}

CommandSender::Time CommandSender::patience() const {
  return command_.opcode == pendant::Opcode::kProgramCommit ? kCommitFactor * repeat_after_ : repeat_after_;
}

std::optional<pendant::FrameBytes> CommandSender::poll(Time now) {
  if (!waiting_ || now < due_) return std::nullopt;
  if (repeats_left_ == 0) {
    waiting_ = false;
    lost_ = true;
    return std::nullopt;
  }
  --repeats_left_;
  ++repeated_;
  due_ = now + patience();
  return encode(command_);
}

bool CommandSender::on_reply(const pendant::Frame& reply) {
  if (!waiting_ || reply.kind != pendant::Kind::kReply || reply.opcode != command_.opcode ||
      reply.sequence != command_.sequence) {
    return false;
  }
  waiting_ = false;
  if (reply.status() == pendant::Status::kBadSequence && reply.payload >= 0) {
    next_sequence_ = static_cast<std::uint8_t>(reply.payload % pendant::kSequences);
  }
  return true;
}

}  // namespace armature::cosim
