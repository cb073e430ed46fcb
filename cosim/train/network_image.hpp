// A perceptron of doubles as the image of a network of 8-bit integers (rtl/policy_mlp/README.md, eight lanes).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cosim/train/mlp.hpp"

namespace armature::cosim {

// Each layer gets integers for its weights: a neuron's largest one is 127. `largest`: the largest value of each layer
// of `mlp` that a 127 shall mean, that of the inputs first.
[[nodiscard]] std::vector<std::uint32_t> network_image(const Mlp& mlp, std::span<const double> largest);

}  // namespace armature::cosim
