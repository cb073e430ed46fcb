// One direction of a serial line whose bytes are lost, changed, repeated, invented or swapped, one after the other. It
// has the timing of the real one: a byte takes 87 us.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>

#include "tests/support/split_mix.hpp"

namespace armature::cosim::test {

using Time = std::chrono::microseconds;
inline constexpr Time kByteTime{87};
inline constexpr Time kCharacterTimeout{4 * 12 * 1'000'000 / 115'741};  // twelve bits each, as the UART counts them

class FaultyLine {
 public:
  // Each kind of fault hits one of `one_in` bytes; 0: never.
  FaultyLine(std::uint64_t seed, std::uint32_t one_in) : random_{seed}, one_in_{one_in} {}

  void send(std::span<const std::uint8_t> bytes) { queue_.insert(queue_.end(), bytes.begin(), bytes.end()); }

  // One byte time has passed: what arrives. Nothing: the line is silent for this time.
  std::optional<std::uint8_t> step() {
    if (queue_.empty()) return std::nullopt;
    const std::uint8_t byte = queue_.front();
    if (hit()) return static_cast<std::uint8_t>(random_.below(256));  // invented; the byte comes after it
    if (hit()) return byte;                                           // comes once more
    if (queue_.size() > 1 && hit()) std::swap(queue_[0], queue_[1]);
    const std::uint8_t next = queue_.front();
    queue_.pop_front();
    if (hit()) return std::nullopt;
    return hit() ? static_cast<std::uint8_t>(next ^ 1u << random_.below(8)) : next;
  }

  [[nodiscard]] bool empty() const { return queue_.empty(); }

 private:
  bool hit() {
    if (one_in_ == 0 || random_.below(one_in_) != 0) return false;
    return true;
  }

  armature::test::SplitMix random_;
  std::uint32_t one_in_;
  std::deque<std::uint8_t> queue_;
};

}  // namespace armature::cosim::test
