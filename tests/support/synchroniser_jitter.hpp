// The uncertainty of a synchroniser, for the input pins of a block: a change near a clock edge may be sampled one edge
// later, each bit by itself. (cosim/fabric/jittery_fabric.hpp does the same to all pins of arm_soc.)
#pragma once

#include <cstdint>

#include "tests/support/split_mix.hpp"

namespace armature::test {

class SynchroniserJitter {
 public:
  SynchroniserJitter(std::uint64_t seed, std::uint32_t levels) : random_{seed}, sampled_{levels} {}

  // Call once per clock with the levels of the pins. Returns the levels that the coming edge samples.
  std::uint32_t sample(std::uint32_t levels) {
    const std::uint32_t changed = levels ^ sampled_;
    late_ = changed & ~late_ & static_cast<std::uint32_t>(random_.next());
    sampled_ ^= changed & ~late_;
    return sampled_;
  }

 private:
  SplitMix random_;
  std::uint32_t sampled_;
  std::uint32_t late_ = 0;  // bits whose change the last edge did not sample
};

}  // namespace armature::test
