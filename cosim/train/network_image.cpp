#include "cosim/train/network_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "controller/policy/policy_scale.hpp"

namespace armature::cosim {
namespace {

constexpr double kFull = PolicyScale::kFull;
constexpr std::size_t kLanes = 8;

// A number between 0 and 1 as multiplier / 2^(16 + shift), with 16 bits.
struct Requantiser {
  std::uint32_t multiplier = 0, shift = 0;
};

Requantiser requantiser(double scale) {
  constexpr double kHalf = 0.5, kOne = 65'536;
  constexpr std::uint32_t kMostShift = 31;
  Requantiser found;
  while (scale < kHalf && found.shift < kMostShift) {
    scale *= 2;
    ++found.shift;
  }
  found.multiplier = static_cast<std::uint32_t>(std::min(std::floor(scale * kOne + kHalf), kOne - 1));
  return found;
}

double largest_weight(std::span<const double> weights) {
  double largest = 1e-12;  // all are 0
  for (const double weight : weights) largest = std::max(largest, std::fabs(weight));
  return largest;
}

std::int32_t rounded_within(double value, double most) {
  const double magnitude = std::min(std::floor(std::fabs(value) + 0.5), most);
  return static_cast<std::int32_t>(value < 0 ? -magnitude : magnitude);
}

// The bytes of a word come one by one.
class ImageWords {
 public:
  void add(std::uint32_t byte) {
    if (bytes_ % 4 == 0) words_.push_back(0);
    words_.back() |= (byte & 0xFFu) << (8 * (bytes_ % 4));
    ++bytes_;
  }
  void add_word(std::uint32_t word) {
    for (unsigned i = 0; i < 4; ++i) add(word >> (8 * i));
  }
  void end_row() {
    while (bytes_ % kLanes != 0) add(0);
  }
  [[nodiscard]] const std::vector<std::uint32_t>& words() const { return words_; }

 private:
  std::vector<std::uint32_t> words_;
  std::size_t bytes_ = 0;
};

// `in` and `out`: what 127 means of the layer before and of this one.
void add_neuron(ImageWords& image, std::span<const double> weights, double bias, double in, double out) {
  constexpr double kMostBias = 8'388'607;
  const double weight = largest_weight(weights) / kFull, product = weight * in / kFull;
  const Requantiser scale = requantiser(product / (out / kFull));
  image.add_word((static_cast<std::uint32_t>(rounded_within(bias / product, kMostBias)) & 0xFF'FFFFu) | scale.shift
                                                                                                            << 24);
  image.add_word(scale.multiplier);
  for (const double value : weights) image.add(static_cast<std::uint32_t>(rounded_within(value / weight, kFull)));
  image.end_row();
}

}  // namespace

std::vector<std::uint32_t> network_image(const Mlp& mlp, std::span<const double> largest) {
  constexpr std::uint32_t kRelu = 1u << 16, kLast = 1u << 17;
  ImageWords image;
  for (std::size_t l = 0; l < mlp.layers().size(); ++l) {
    const MlpLayer& layer = mlp.layers()[l];
    const bool last = l + 1 == mlp.layers().size();
    const std::size_t rows = (layer.inputs + kLanes - 1) / kLanes;
    image.add_word(static_cast<std::uint32_t>((layer.biases.size() - 1) | (rows - 1) << 8) | (last ? kLast : kRelu));
    image.end_row();
    for (std::size_t n = 0; n < layer.biases.size(); ++n) {
      add_neuron(image, std::span{layer.weights}.subspan(n * layer.inputs, layer.inputs), layer.biases[n], largest[l],
                 largest[l + 1]);
    }
  }
  return image.words();
}

}  // namespace armature::cosim
