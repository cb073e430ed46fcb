// How core 1 wants plans to be run through: a hold, and an override of the rate.
//
// This is a state and no order: core 0 reads it in each tick, nothing queues up, and the last word counts.
#pragma once

#include <atomic>
#include <cstdint>

#include "controller/core/rounding.hpp"

namespace armature {

class RunControl {
 public:
  // What core 0 reads in one go.
  struct View {
    bool hold = false;
    double share = 1.0;  // of the planned rate, in whole millionths
  };

  // Core 1. What it has pushed before releasing a hold core 0 sees as soon as it sees the release.
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
