// Networks of policy_mlp for its tests: random ones, their images, and what they compute, in plain arithmetic.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/support/split_mix.hpp"

namespace armature::test {

struct TestNeuron {
  std::int32_t bias = 0;             // 24 bits, signed
  std::uint32_t multiplier = 0;      // 16 bits
  std::uint32_t shift = 0;           // 5 bits
  std::vector<std::int8_t> weights;  // by input
};
struct TestLayer {
  bool relu = false;
  std::vector<TestNeuron> neurons;
};
using TestNetwork = std::vector<TestLayer>;
using TestImage = std::vector<std::uint32_t>;

// The image, row by row of `lanes` bytes; rtl/policy_mlp/README.md.
inline TestImage image_of(const TestNetwork& network, std::size_t lanes) {
  std::vector<std::uint8_t> bytes;
  const auto end_row = [&] { bytes.resize((bytes.size() + lanes - 1) / lanes * lanes); };
  const auto add = [&](std::uint64_t value, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  };
  for (std::size_t l = 0; l < network.size(); ++l) {
    const TestLayer& layer = network[l];
    const std::size_t rows = (layer.neurons[0].weights.size() + lanes - 1) / lanes;
    add((layer.neurons.size() - 1) | (rows - 1) << 8 | (layer.relu ? 1u << 16 : 0u) |
            (l + 1 == network.size() ? 1u << 17 : 0u),
        4);
    end_row();
    for (const TestNeuron& neuron : layer.neurons) {
      add(static_cast<std::uint32_t>(neuron.bias) & 0xFF'FFFFu, 3);
      add(neuron.shift, 1);
      add(neuron.multiplier, 4);
      end_row();
      for (const std::int8_t weight : neuron.weights) add(static_cast<std::uint8_t>(weight), 1);
      end_row();
    }
  }
  TestImage image(bytes.size() / 4);
  for (std::size_t i = 0; i < bytes.size(); ++i) image[i / 4] |= std::uint32_t{bytes[i]} << (8 * (i % 4));
  return image;
}

// The outputs without the bound. Every step is exact in double.
inline std::vector<std::int8_t> outputs_of(const TestNetwork& network, std::vector<std::int8_t> values) {
  for (const TestLayer& layer : network) {
    std::vector<std::int8_t> given;
    for (const TestNeuron& neuron : layer.neurons) {
      double sum = neuron.bias;
      for (std::size_t i = 0; i < neuron.weights.size(); ++i) sum += double{neuron.weights[i] * 1.0} * values[i];
      const double scale = neuron.multiplier / std::exp2(16 + neuron.shift);
      const double rounded = std::floor(sum * scale + 0.5);
      given.push_back(static_cast<std::int8_t>(std::clamp(rounded, layer.relu ? 0.0 : -128.0, 127.0)));
    }
    values = given;
  }
  return values;
}

class RandomNetworks {
 public:
  explicit RandomNetworks(std::uint64_t seed) : random_{seed} {}

  // Layers of the sizes {inputs, hidden..., outputs}.
  TestNetwork of(const std::vector<std::size_t>& sizes) {
    TestNetwork network;
    for (std::size_t l = 1; l < sizes.size(); ++l) {
      TestLayer layer{.relu = l + 1 < sizes.size() || random_.below(4) == 0};
      for (std::size_t n = 0; n < sizes[l]; ++n) layer.neurons.push_back(neuron(sizes[l - 1]));
      network.push_back(layer);
    }
    return network;
  }
  // Any shape, seldom the largest.
  TestNetwork next() {
    std::vector<std::size_t> sizes{1 + random_.below(32)};
    for (std::size_t hidden = random_.below(4); hidden > 0; --hidden) sizes.push_back(1 + random_.below(most()));
    sizes.push_back(1 + random_.below(8));
    return of(sizes);
  }
  std::vector<std::int8_t> inputs(std::size_t count) {
    const bool extreme = random_.below(8) == 0;
    std::vector<std::int8_t> values(count);
    for (std::int8_t& value : values) value = extreme ? (random_.below(2) == 0 ? -128 : 127) : byte();
    return values;
  }
  std::int8_t byte() { return static_cast<std::int8_t>(random_.below(256)); }
  SplitMix& random() { return random_; }

 private:
  std::uint32_t most() { return random_.below(4) == 0 ? 64 : 20; }

  TestNeuron neuron(std::size_t inputs) {
    TestNeuron neuron;
    neuron.weights.resize(inputs);
    const bool extreme = random_.below(16) == 0;
    for (std::int8_t& weight : neuron.weights) weight = extreme ? -128 : byte();
    if (random_.below(8) == 0) {  // anything
      neuron.bias = static_cast<std::int32_t>(random_.next()) >> 8;
      neuron.multiplier = random_.below(0x1'0000);
      neuron.shift = random_.below(32);
    } else {  // values that neither vanish nor are limited always
      neuron.bias = static_cast<std::int32_t>(random_.below(20'000)) - 10'000;
      neuron.multiplier = 0x8000 + random_.below(0x8000);
      neuron.shift = 6 + random_.below(3) + static_cast<std::uint32_t>(std::bit_width(inputs) / 2);
    }
    return neuron;
  }

  SplitMix random_;
};

}  // namespace armature::test
