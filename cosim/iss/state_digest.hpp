// A digest of a state that takes megabytes: equal states have equal digests, and others differ but by chance.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "cosim/time/mixed.hpp"

namespace armature::cosim::iss {

class StateDigest {
 public:
  void add(std::uint64_t value) { lanes_[0] = mixed(lanes_[0], value); }

  // Four lanes at the same time, because each step waits for the one before.
  void add(std::span<const std::uint8_t> bytes) {
    std::array<std::uint64_t, kLanes> words{};
    for (; bytes.size() >= sizeof words; bytes = bytes.subspan(sizeof words)) {
      std::memcpy(words.data(), bytes.data(), sizeof words);
      for (std::size_t lane = 0; lane < kLanes; ++lane) lanes_[lane] = mixed(lanes_[lane], words[lane]);
    }
    for (const std::uint8_t byte : bytes) add(byte);
  }

  [[nodiscard]] std::uint64_t value() const {
    std::uint64_t all = 0;
    for (const std::uint64_t lane : lanes_) all = mixed(all, lane);
    return all;
  }

 private:
  static constexpr std::size_t kLanes = 4;

  std::array<std::uint64_t, kLanes> lanes_{1, 2, 3, 4};
};

}  // namespace armature::cosim::iss
