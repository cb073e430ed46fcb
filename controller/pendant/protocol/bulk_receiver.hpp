// Receives the text of a program: six characters in each bulk frame, in order (go-back-N).
//
// A frame that is not the next one is dropped. The first one of these, and then one in each window, causes an
// acknowledgement with kBadSequence. An acknowledgement has the number of frames that were received without
// a gap, so a later one replaces all that were lost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "controller/pendant/protocol/crc32.hpp"
#include "controller/pendant/protocol/frame.hpp"

namespace armature::pendant {

inline constexpr std::int32_t kBulkWindow = 8;     // frames that the pendant sends without an acknowledgement, at most
inline constexpr std::int32_t kBulkAckFrames = 4;  // the controller acknowledges every fourth frame, and the last one

class BulkReceiver {
 public:
  // `store` must outlive the receiver.
  explicit BulkReceiver(std::span<char> store) noexcept : store_{store} {}

  // Expects this number of characters from now on; false when the store is smaller.
  [[nodiscard]] bool begin(std::int32_t size) noexcept;
  void cancel() noexcept { size_ = 0; }

  // The acknowledgement to send, if it is time for one.
  [[nodiscard]] std::optional<Frame> push(const BulkFrame& frame) noexcept;

  [[nodiscard]] bool complete() const noexcept { return size_ > 0 && received_ == size_; }
  // What was received; its check value when it is complete.
  [[nodiscard]] std::span<const char> text() const noexcept {
    return store_.first(static_cast<std::size_t>(received_));
  }
  [[nodiscard]] std::int32_t check() const noexcept { return crc_.check(); }

 private:
  [[nodiscard]] Frame acknowledgement(Status status) const noexcept;

  std::span<char> store_;
  std::int32_t size_ = 0;  // 0: no transfer
  std::int32_t received_ = 0;
  std::int32_t frames_ = 0;
  std::int32_t unexpected_ = 0;  // frames since the last expected one
  Crc32 crc_;
};

}  // namespace armature::pendant
