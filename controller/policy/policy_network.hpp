// A network of 8-bit integers in software: the plain reference of the block policy_mlp, and the way "network on ARM".
//
// It reads the same image (rtl/policy_mlp/README.md, eight lanes) and gives the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace armature {

class PolicyNetwork {
 public:
  static constexpr std::size_t kMostLayers = 4;
  static constexpr std::size_t kMostInputs = 32;
  static constexpr std::size_t kMostNeurons = 64;
  static constexpr std::size_t kMostOutputs = 8;
  using Outputs = std::array<std::int8_t, kMostOutputs>;

  // `image`: must live as long as the network. None: it has a fifth layer or no end.
  [[nodiscard]] static std::optional<PolicyNetwork> decode(std::span<const std::uint32_t> image) noexcept;

  // CRC-32 (as zlib) of words, the low byte of each first: what a run of the block computes of the words that it reads.
  [[nodiscard]] static std::uint32_t checksum(std::span<const std::uint32_t> words) noexcept;

  // Inputs that are missing are 0, as outputs that the network does not have. No output exceeds `bound` (0..127).
  [[nodiscard]] Outputs evaluate(std::span<const std::int8_t> inputs, std::uint8_t bound) const noexcept;

  [[nodiscard]] std::size_t layers() const noexcept { return count_; }
  [[nodiscard]] std::size_t words() const noexcept { return words_; }  // of the image that a run reads

 private:
  using Values = std::array<std::int8_t, kMostNeurons>;
  struct Layer {
    std::span<const std::uint32_t> neurons;  // parameters and weights of all
    std::size_t rows = 0;                    // of 8 weights, for each neuron
    bool relu = false;

    // Words of a neuron.
    [[nodiscard]] std::size_t stride() const noexcept { return 2 * (rows + 1); }
  };
  [[nodiscard]] static Values evaluate(const Layer& layer, const Values& values) noexcept;

  std::array<Layer, kMostLayers> layers_{};
  std::size_t count_ = 0, words_ = 0;
};

}  // namespace armature
