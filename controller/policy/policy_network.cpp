#include "controller/policy/policy_network.hpp"

#include <algorithm>

#include "controller/base/crc32.hpp"

namespace armature {
namespace {

constexpr std::uint32_t kReluBit = 1u << 16, kLastBit = 1u << 17;

// Byte `i` of an image.
[[nodiscard]] std::int32_t signed_byte(std::span<const std::uint32_t> words, std::size_t i) noexcept {
  return static_cast<std::int8_t>(words[i / 4] >> (8 * (i % 4)));
}

// Exact: 25 bits times 16.
[[nodiscard]] std::int8_t to_byte(std::int64_t sum, std::uint32_t multiplier, unsigned shift, bool relu) noexcept {
  const std::int64_t half = std::int64_t{1} << (shift - 1);
  const std::int64_t rounded = (sum * static_cast<std::int64_t>(multiplier) + half) >> shift;
  return static_cast<std::int8_t>(std::clamp<std::int64_t>(rounded, relu ? 0 : INT8_MIN, INT8_MAX));
}

}  // namespace

std::uint32_t PolicyNetwork::checksum(std::span<const std::uint32_t> words) noexcept {
  Crc32 sum;
  for (const std::uint32_t word : words) sum.add(word);
  return sum.value();
}

std::optional<PolicyNetwork> PolicyNetwork::decode(std::span<const std::uint32_t> image) noexcept {
  PolicyNetwork network;
  std::size_t at = 0;
  for (Layer& layer : network.layers_) {
    if (at + 2 > image.size()) return std::nullopt;
    const std::uint32_t head = image[at];
    layer.rows = (head >> 8 & 7u) + 1;
    layer.relu = (head & kReluBit) != 0;
    const std::size_t size = ((head & 0x3Fu) + 1) * layer.stride();
    if (size > image.size() - at - 2) return std::nullopt;
    layer.neurons = image.subspan(at + 2, size);
    at += 2 + size;
    ++network.count_;
    network.words_ = at;
    if ((head & kLastBit) != 0) return network;
  }
  return std::nullopt;
}

PolicyNetwork::Values PolicyNetwork::evaluate(const Layer& layer, const Values& values) noexcept {
  Values given{};
  const std::size_t count = layer.neurons.size() / layer.stride();
  for (std::size_t n = 0; n < count; ++n) {
    const auto words = layer.neurons.subspan(n * layer.stride(), layer.stride());
    std::int64_t sum = static_cast<std::int32_t>(words[0] << 8) / 256;  // the bias has 24 bits
    const auto weights = words.subspan(2);
    for (std::size_t i = 0; i < 8 * layer.rows; ++i) sum += std::int64_t{signed_byte(weights, i)} * values[i];
    given[n] = to_byte(sum, words[1] & 0xFFFFu, 16 + (words[0] >> 24 & 0x1Fu), layer.relu);
  }
  return given;
}

PolicyNetwork::Outputs PolicyNetwork::evaluate(std::span<const std::int8_t> inputs, std::uint8_t bound) const noexcept {
  Values values{};
  std::copy_n(inputs.begin(), std::min(inputs.size(), kMostInputs), values.begin());
  for (std::size_t i = 0; i < count_; ++i) values = evaluate(layers_[i], values);
  Outputs outputs{};
  const int limit = std::min<int>(bound, INT8_MAX);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    outputs[i] = static_cast<std::int8_t>(std::clamp<int>(values[i], -limit, limit));
  }
  return outputs;
}

}  // namespace armature
