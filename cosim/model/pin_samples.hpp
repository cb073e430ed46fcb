// The levels that the latest clock edges have sampled at an input pin, or at several pins as the bits of a word: what
// is left of a synchroniser and of the stages behind it. In reset the pin counts as 0.
#pragma once

#include <array>
#include <cstddef>

namespace armature::cosim::model {

template <class Level, std::size_t kDepth>
class PinSamples {
 public:
  // Before the edge n: the sample of the edge n - `edges`, for 1 to kDepth edges.
  [[nodiscard]] const Level& ago(std::size_t edges) const { return samples_[edges - 1]; }

  // The edge n.
  void sample(const Level& level) {
    for (std::size_t i = kDepth - 1; i > 0; --i) samples_[i] = samples_[i - 1];
    samples_[0] = level;
  }

  // As if many edges had sampled `level`.
  void fill(const Level& level) { samples_.fill(level); }

  friend bool operator==(const PinSamples&, const PinSamples&) = default;

  // Whether further edges change nothing if they sample `level`.
  [[nodiscard]] bool are_settled(const Level& level) const { return samples_[0] == level && are_equal(); }

  // Whether edges that sample the same level again change nothing.
  [[nodiscard]] bool are_equal() const {
    bool equal = true;
    for (std::size_t i = 1; i < kDepth; ++i) equal = equal && samples_[i] == samples_[0];
    return equal;
  }

 private:
  std::array<Level, kDepth> samples_{};
};

}  // namespace armature::cosim::model
