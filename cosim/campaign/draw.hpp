// Random values of a campaign. They come from SplitMix64 with integers and plain arithmetic only, so that a seed gives
// the same values on every machine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cosim/time/random.hpp"

namespace armature::cosim {

class Draw {
 public:
  // `stream` and `number` name a sequence of the seed: the sequences of different numbers have nothing in common.
  Draw(std::uint64_t seed, std::uint64_t stream, std::uint64_t number)
      : random_{Random{seed}.next() ^ Random{(number << 8) + stream}.next()} {}

  [[nodiscard]] bool chance(double probability) { return random_.chance(probability); }

  // Both ends are possible.
  [[nodiscard]] std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(random_.next() % (static_cast<std::uint64_t>(high - low) + 1));
  }
  template <class List>
  [[nodiscard]] const auto& one_of(const List& list) {
    return list[static_cast<std::size_t>(integer(0, static_cast<std::int64_t>(list.size()) - 1))];
  }
  [[nodiscard]] double number(double low, double high) { return random_.between(low, high); }
  // Each decade between both ends, which are above 0, is equally likely. The value has three digits.
  [[nodiscard]] double decades(double low, double high);
  [[nodiscard]] std::uint64_t seed() { return random_.next() >> 1; }

 private:
  Random random_;
};

}  // namespace armature::cosim
