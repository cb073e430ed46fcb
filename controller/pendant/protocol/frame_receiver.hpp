// Finds the frames in the bytes of the line.
//
// It keeps the last eight bytes. They are a frame when they are valid; then all eight are used up. Otherwise the oldest
// one is dropped when the next one comes, so the receiver finds the next frame after lost or additional bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/pendant/protocol/frame.hpp"

namespace armature::pendant {

class FrameReceiver {
 public:
  explicit FrameReceiver(End end) noexcept : end_{end} {}

  // The frame that this byte completes. A caller gets at most one for each byte.
  [[nodiscard]] std::optional<FrameBytes> push(std::uint8_t byte) noexcept;

  // Drops the bytes of the frame under way: nothing came for the time of four characters, or a character had an error.
  // Call it before push() of the next byte.
  void discard() noexcept;

  // Number of bytes that were dropped since the start: noise, and parts of damaged frames. Wraps.
  [[nodiscard]] std::uint32_t dropped() const noexcept { return dropped_; }

 private:
  End end_;
  FrameBytes window_{};
  std::size_t filled_ = 0;
  std::uint32_t dropped_ = 0;
};

}  // namespace armature::pendant
