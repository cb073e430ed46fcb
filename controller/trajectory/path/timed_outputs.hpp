// The outputs of a plan: which output of the tool is switched, and when.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/base/tag.hpp"

namespace armature {

// It is switched when the plan has been executed up to a time.
struct TimedOutput {
  double ticks = 0.0;  // of the plan, 0..duration
  Tag tag{};           // of the command
  std::uint8_t pin = 0;
  bool level = false;
};

// In the order of time; at most kMax.
class TimedOutputs {
 public:
  static constexpr std::size_t kMax = 32;

  TimedOutputs() = default;
  // Copies only the outputs that there are.
  TimedOutputs(const TimedOutputs& other) noexcept { *this = other; }
  TimedOutputs& operator=(const TimedOutputs& other) noexcept {
    count_ = other.count_;
    std::copy_n(other.list_.begin(), count_, list_.begin());
    return *this;
  }

  void clear() noexcept { count_ = 0; }
  // Behind those of the same time. There must be room.
  void insert(const TimedOutput& output) noexcept {
    std::size_t at = count_++;
    for (; at > 0 && list_[at - 1].ticks > output.ticks; --at) list_[at] = list_[at - 1];
    list_[at] = output;
  }
  [[nodiscard]] std::span<const TimedOutput> view() const noexcept { return {list_.data(), count_}; }

 private:
  std::array<TimedOutput, kMax> list_{};
  std::size_t count_ = 0;
};

}  // namespace armature
