#include "controller/pendant/protocol/frame_receiver.hpp"

#include <algorithm>

namespace armature::pendant {

std::optional<FrameBytes> FrameReceiver::push(std::uint8_t byte) noexcept {
  if (filled_ == kFrameBytes) {
    std::shift_left(window_.begin(), window_.end(), 1);
    --filled_;
    ++dropped_;
  }
  window_[filled_++] = byte;
  if (filled_ < kFrameBytes || !valid(window_, end_)) return std::nullopt;
  filled_ = 0;
  return window_;
}

void FrameReceiver::discard() noexcept {
  dropped_ += static_cast<std::uint32_t>(filled_);
  filled_ = 0;
}

}  // namespace armature::pendant
