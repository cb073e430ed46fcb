// The simulation's only source of randomness: SplitMix64 (Steele, Lea and Flood 2014), the same sequence on every
// machine.
#pragma once

#include <cstdint>

namespace armature::cosim {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_{seed} {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  // A multiple of 2^-53 in [0, 1).
  double unit() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  // In [low, high).
  double between(double low, double high) { return low + (high - low) * unit(); }
  // True with the given probability, to 2^-53.
  bool chance(double probability) { return unit() < probability; }

 private:
  std::uint64_t state_;
};

}  // namespace armature::cosim
