#include "cosim/model/policy_mlp/network_run.hpp"

#include <algorithm>
#include <optional>
#include <span>

namespace armature::cosim::model::mlp {
namespace {

// The image from its first row on.
class ImageReader {
 public:
  ImageReader(const Memory& memory, std::size_t lanes) : memory_{memory}, lanes_{lanes} {}

  [[nodiscard]] std::size_t rows() const { return rows_; }  // that were read
  [[nodiscard]] bool at_end() const { return rows_ * lanes_ == 4 * kMemoryWords; }
  [[nodiscard]] std::uint32_t crc() const { return ~crc_; }

  void next() {
    first_ = rows_++ * lanes_;
    for (std::size_t i = 0; i < lanes_; ++i) add(byte(i));
  }
  // Of the present row.
  [[nodiscard]] std::uint8_t byte(std::size_t i) const {
    const std::size_t at = first_ + i;
    return static_cast<std::uint8_t>(memory_[at / 4] >> (8 * (at % 4)));
  }
  [[nodiscard]] std::uint32_t word(std::size_t i) const { return memory_[first_ / 4 + i]; }

 private:
  void add(std::uint8_t byte) {
    crc_ ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc_ = (crc_ >> 1) ^ ((crc_ & 1u) != 0 ? 0xEDB8'8320u : 0u);
  }

  const Memory& memory_;
  std::size_t lanes_, rows_ = 0, first_ = 0;
  std::uint32_t crc_ = 0xFFFF'FFFFu;
};

struct Parameters {
  std::int64_t bias;
  std::uint32_t multiplier, shift;
};

class Run {
 public:
  Run(const Memory& memory, std::size_t lanes, const Inputs& inputs) : image_{memory, lanes}, lanes_{lanes} {
    std::ranges::copy(inputs, values_.begin());
  }

  Outcome outcome() {
    int drained = 0;
    bool complete = true;
    do {
      complete = layer();
      ++drained;
    } while (complete && !last_ && drained < static_cast<int>(kMostLayers));
    Outcome outcome{.crc = image_.crc(),
                    .malformed = !complete || !last_,
                    .clocks = 1 + static_cast<int>(image_.rows()) + kPipeline * drained};
    std::copy_n(values_.begin(), kOutputs, outcome.outputs.begin());
    return outcome;
  }

 private:
  // Reads a row. Returns false when it was the last one of the memory.
  bool next() {
    image_.next();
    return !image_.at_end();
  }

  // Returns false when the memory ends before the network does.
  bool layer() {
    const bool more = next();
    const std::uint32_t head = image_.word(0);
    const std::size_t neurons = (head & 0x3Fu) + 1;
    const std::size_t rows = ((head >> 8) & (kMostNeurons / lanes_ - 1)) + 1;
    const bool relu = (head >> 16 & 1u) != 0;
    last_ = (head >> 17 & 1u) != 0;
    if (!more) return false;
    std::array<std::int8_t, kMostNeurons> given{};
    for (std::size_t neuron = 0; neuron < neurons; ++neuron) {
      const std::optional<Parameters> parameters = read_parameters();
      if (!parameters) return false;
      std::int64_t sum = parameters->bias;
      for (std::size_t row = 0; row < rows; ++row) {
        const bool end = !next();
        for (std::size_t i = 0; i < lanes_; ++i) {
          sum += std::int64_t{static_cast<std::int8_t>(image_.byte(i))} * values_[row * lanes_ + i];
        }
        if (end && !(last_ && neuron + 1 == neurons && row + 1 == rows)) return false;
      }
      given[neuron] = requantised(sum, parameters->multiplier, parameters->shift, relu);
    }
    values_ = given;
    return true;
  }

  std::optional<Parameters> read_parameters() {
    bool more = next();
    const std::uint32_t low = image_.word(0);
    if (lanes_ == 4) {
      if (!more) return std::nullopt;
      more = next();
    }
    const std::uint32_t high = image_.word(lanes_ == 4 ? 0 : 1);
    if (!more) return std::nullopt;
    const std::int64_t bias = static_cast<std::int32_t>(low << 8) >> 8;
    return Parameters{.bias = bias, .multiplier = high & 0xFFFFu, .shift = low >> 24 & 0x1Fu};
  }

  ImageReader image_;
  std::size_t lanes_;
  std::array<std::int8_t, kMostNeurons> values_{};
  bool last_ = false;
};

}  // namespace

std::int8_t requantised(std::int64_t sum, std::uint32_t multiplier, std::uint32_t shift, bool relu) {
  const std::int64_t product = sum * multiplier;
  const std::int64_t half = std::int64_t{1} << (15 + shift);
  const std::int64_t value = (product + half) >> (16 + shift);
  return static_cast<std::int8_t>(std::clamp<std::int64_t>(value, relu ? 0 : -128, 127));
}

Outcome evaluate(const Memory& memory, std::size_t lanes, const Inputs& inputs) {
  return Run{memory, lanes, inputs}.outcome();
}

}  // namespace armature::cosim::model::mlp
