// The hold and the feed override that core 1 requests.
//
// This is a state, not an order: core 0 reads the latest value in each tick, and nothing queues up.
#pragma once

#include <atomic>
#include <cstdint>

#include "controller/base/rounding.hpp"

namespace armature {

class RunControl {
 public:
  // A consistent read by core 0.
  struct View {
    bool hold = false;
    double share = 1.0;  // of the planned rate, in whole millionths
  };

  // Core 1. When core 0 sees a released hold, it also sees everything that core 1 pushed before the release.
  void set_hold(bool hold) noexcept {
    const std::uint32_t word = word_.load(std::memory_order_relaxed);
    word_.store(hold ? word | kHold : word & ~kHold, std::memory_order_release);
  }
  // 0 < share <= 1.
  void set_share(double share) noexcept {
    const std::uint32_t hold = word_.load(std::memory_order_relaxed) & kHold;
    word_.store(hold | static_cast<std::uint32_t>(round_half_away(share * kWhole)), std::memory_order_release);
  }

  // Core 0.
  [[nodiscard]] View view() const noexcept {
    const std::uint32_t word = word_.load(std::memory_order_acquire);
    return {.hold = (word & kHold) != 0, .share = static_cast<double>(word & ~kHold) / kWhole};
  }

 private:
  static constexpr std::uint32_t kHold = 1u << 31;
  static constexpr double kWhole = 1e6;

  std::atomic<std::uint32_t> word_{static_cast<std::uint32_t>(kWhole)};
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
};

}  // namespace armature
