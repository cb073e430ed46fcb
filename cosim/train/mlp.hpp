// A multi-layer perceptron of doubles with ReLU in the hidden layers, and its training by Adam (Kingma and Ba 2015).
//
// The order of all additions is fixed, and only +, -, *, / and sqrt are used: the same bytes on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cosim/time/random.hpp"

namespace armature::cosim {

struct MlpLayer {
  std::size_t inputs = 0;
  std::vector<double> weights;  // of a neuron, then of the next one
  std::vector<double> biases;   // one for each neuron
};

class Mlp {
 public:
  // Layers of the sizes {inputs, hidden..., outputs}, with random weights (He et al. 2015).
  Mlp(std::span<const std::size_t> sizes, Random& random);

  [[nodiscard]] const std::vector<MlpLayer>& layers() const { return layers_; }
  // The values of each layer, that of the inputs first. Valid until the next call.
  [[nodiscard]] const std::vector<std::vector<double>>& evaluate(std::span<const double> inputs);

  // Adds the gradient of half the square of (output - wanted) at the last inputs; returns the difference. One output.
  double add_gradient(double wanted);
  // A step with the mean of `count` gradients, which it then forgets.
  void step(std::size_t count, double rate);

 private:
  struct Moments {
    std::vector<double> gradient, first, second;
  };
  void descend(std::vector<double>& values, Moments& moments, double share, double rate) const;

  std::vector<MlpLayer> layers_;
  std::vector<Moments> weights_, biases_;  // of each layer
  std::vector<std::vector<double>> values_, slopes_;
  double first_left_ = 1, second_left_ = 1;  // powers of the decays
};

}  // namespace armature::cosim
