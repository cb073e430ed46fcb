// What policy_mlp computes, bit for bit: a run of the network whose image is in its memory. rtl/policy_mlp/README.md
// describes the image and the arithmetic.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace armature::cosim::model::mlp {

inline constexpr std::size_t kInputs = 32;
inline constexpr std::size_t kOutputs = 8;
inline constexpr std::size_t kMostNeurons = 64;  // of a layer
inline constexpr std::size_t kMostLayers = 4;
inline constexpr std::size_t kMemoryWords = 4096;
inline constexpr int kPipeline = 5;  // clocks between two layers, and after the last one

using Memory = std::array<std::uint32_t, kMemoryWords>;
using Inputs = std::array<std::int8_t, kInputs>;

struct Outcome {
  std::array<std::int8_t, kOutputs> outputs{};  // not limited to BOUND; of a malformed image without meaning
  std::uint32_t crc = 0;                        // of what was read
  bool malformed = false;                       // a fifth layer, or no end in the memory
  int clocks = 0;                               // that the block is busy

  [[nodiscard]] bool operator==(const Outcome&) const = default;
};

// `lanes`: 4, 8 or 16, the bytes of a row.
[[nodiscard]] Outcome evaluate(const Memory& memory, std::size_t lanes, const Inputs& inputs);

// The sum of a neuron as 8 bits.
[[nodiscard]] std::int8_t requantised(std::int64_t sum, std::uint32_t multiplier, std::uint32_t shift, bool relu);

}  // namespace armature::cosim::model::mlp
