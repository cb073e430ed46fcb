#include "cosim/train/mlp.hpp"

#include <algorithm>
#include <cmath>

namespace armature::cosim {
namespace {

constexpr double kFirstDecay = 0.9, kSecondDecay = 0.999, kLeastScale = 1e-8;

}  // namespace

Mlp::Mlp(std::span<const std::size_t> sizes, Random& random) {
  values_.emplace_back(sizes[0]);
  slopes_.emplace_back(sizes[0]);
  for (std::size_t l = 1; l < sizes.size(); ++l) {
    const std::size_t inputs = sizes[l - 1], count = sizes[l];
    MlpLayer layer{
        .inputs = inputs, .weights = std::vector<double>(inputs * count), .biases = std::vector<double>(count)};
    const double most = std::sqrt(6.0 / static_cast<double>(inputs));
    for (double& weight : layer.weights) {
      weight = most * (2 * random.unit() - 1.0);
    }
    const auto zeros = [](std::size_t size) {
      return Moments{std::vector<double>(size), std::vector<double>(size), std::vector<double>(size)};
    };
    weights_.push_back(zeros(inputs * count));
    biases_.push_back(zeros(count));
    layers_.push_back(std::move(layer));
    values_.emplace_back(count);
    slopes_.emplace_back(count);
  }
}

const std::vector<std::vector<double>>& Mlp::evaluate(std::span<const double> inputs) {
  std::ranges::copy(inputs, values_[0].begin());
  for (std::size_t l = 0; l < layers_.size(); ++l) {
    const MlpLayer& layer = layers_[l];
    const bool hidden = l + 1 < layers_.size();
    for (std::size_t n = 0; n < layer.biases.size(); ++n) {
      double sum = layer.biases[n];
      for (std::size_t i = 0; i < layer.inputs; ++i) sum += layer.weights[n * layer.inputs + i] * values_[l][i];
      values_[l + 1][n] = hidden ? std::max(sum, 0.0) : sum;
    }
  }
  return values_;
}

double Mlp::add_gradient(double wanted) {
  const double difference = values_.back()[0] - wanted;
  slopes_.back()[0] = difference;
  for (std::size_t l = layers_.size(); l-- > 0;) {
    const MlpLayer& layer = layers_[l];
    std::ranges::fill(slopes_[l], 0.0);
    for (std::size_t n = 0; n < layer.biases.size(); ++n) {
      const bool cut = l + 1 < layers_.size() && values_[l + 1][n] <= 0.0;
      if (cut) continue;
      const double slope = slopes_[l + 1][n];
      biases_[l].gradient[n] += slope;
      for (std::size_t i = 0; i < layer.inputs; ++i) {
        weights_[l].gradient[n * layer.inputs + i] += slope * values_[l][i];
        slopes_[l][i] += slope * layer.weights[n * layer.inputs + i];
      }
    }
  }
  return difference;
}

void Mlp::step(std::size_t count, double rate) {
  first_left_ *= kFirstDecay;
  second_left_ *= kSecondDecay;
  const double share = 1.0 / static_cast<double>(count);
  for (std::size_t l = 0; l < layers_.size(); ++l) {
    descend(layers_[l].weights, weights_[l], share, rate);
    descend(layers_[l].biases, biases_[l], share, rate);
  }
}

void Mlp::descend(std::vector<double>& values, Moments& moments, double share, double rate) const {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double gradient = moments.gradient[i] * share;
    moments.gradient[i] = 0;
    moments.first[i] = kFirstDecay * moments.first[i] + (1 - kFirstDecay) * gradient;
    moments.second[i] = kSecondDecay * moments.second[i] + (1 - kSecondDecay) * gradient * gradient;
    const double mean = moments.first[i] / (1 - first_left_), scale = std::sqrt(moments.second[i] / (1 - second_left_));
    values[i] -= rate * mean / (scale + kLeastScale);
  }
}

}  // namespace armature::cosim
