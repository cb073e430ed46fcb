#include "controller/pendant/protocol/bulk_receiver.hpp"

namespace armature::pendant {

bool BulkReceiver::begin(std::int32_t size) noexcept {
  *this = BulkReceiver{store_};
  if (size <= 0 || static_cast<std::size_t>(size) > store_.size()) return false;
  size_ = size;
  return true;
}

std::optional<Frame> BulkReceiver::push(const BulkFrame& frame) noexcept {
  if (size_ == 0) return std::nullopt;
  if (complete()) return acknowledgement(Status::kOk);
  if (frame.sequence != frames_ % kSequences) {
    if (unexpected_++ % kBulkWindow == 0) return acknowledgement(Status::kBadSequence);
    return std::nullopt;
  }
  unexpected_ = 0;
  for (const std::uint8_t character : frame.text) {
    if (received_ == size_) break;  // the last frame is filled
    store_[static_cast<std::size_t>(received_++)] = static_cast<char>(character);
    crc_.add(character);
  }
  ++frames_;
  if (complete() || frames_ % kBulkAckFrames == 0) return acknowledgement(Status::kOk);
  return std::nullopt;
}

Frame BulkReceiver::acknowledgement(Status status) const noexcept {
  return {.kind = Kind::kReply,
          .sequence = static_cast<std::uint8_t>(frames_ % kSequences),
          .opcode = Opcode::kProgramData,
          .parameter = static_cast<std::uint8_t>(status),
          .payload = frames_};
}

}  // namespace armature::pendant
