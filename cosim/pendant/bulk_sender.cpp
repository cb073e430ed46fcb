#include "cosim/pendant/bulk_sender.hpp"

#include <algorithm>
#include <cstddef>

#include "controller/pendant/protocol/bulk_receiver.hpp"
#include "controller/pendant/protocol/crc32.hpp"

namespace armature::cosim {

using pendant::BulkFrame;

std::optional<pendant::FrameBytes> BulkSender::poll(Time now) {
  if (complete()) return std::nullopt;
  if (window_is_full()) {
    if (now < due_) return std::nullopt;
    go_back(now);
  }
  BulkFrame frame{.sequence = static_cast<std::uint8_t>(next_ % pendant::kSequences)};
  const std::size_t begin = static_cast<std::size_t>(next_) * BulkFrame::kCharacters;
  const std::size_t count = std::min(BulkFrame::kCharacters, text_.size() - begin);
  for (std::size_t i = 0; i < count; ++i) frame.text[i] = static_cast<std::uint8_t>(text_[begin + i]);
  ++next_;
  due_ = now + repeat_after_;
  return encode(frame);
}

void BulkSender::on_reply(const pendant::Frame& reply, Time now) {
  if (reply.kind != pendant::Kind::kReply || reply.opcode != pendant::Opcode::kProgramData) return;
  if (reply.payload < acknowledged_ || reply.payload > next_) return;  // late, or from another transfer
  acknowledged_ = reply.payload;
  if (reply.status() == pendant::Status::kBadSequence) go_back(now);
}

std::int32_t BulkSender::check() const {
  pendant::Crc32 crc;
  for (const char character : text_) crc.add(static_cast<std::uint8_t>(character));
  return crc.check();
}

std::int32_t BulkSender::frames() const {
  return static_cast<std::int32_t>((text_.size() + BulkFrame::kCharacters - 1) / BulkFrame::kCharacters);
}

bool BulkSender::window_is_full() const {
  return next_ == frames() || next_ - acknowledged_ >= pendant::kBulkWindow;
}

void BulkSender::go_back(Time now) {
  repeated_ += next_ - acknowledged_;
  next_ = acknowledged_;
  due_ = now + repeat_after_;
}

}  // namespace armature::cosim
