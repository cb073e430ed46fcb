#include "cosim/train/mlp.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace armature::cosim {
namespace {

constexpr std::array<std::size_t, 4> kSizes{3, 5, 4, 1};
constexpr std::array kInputs{0.3, -0.7, 0.9};

// Adam's first step moves each value by the rate against the sign of its gradient, whatever its size.
TEST(Mlp, TheFirstStepGoesAgainstTheGradientThatDifferencesGive) {
  constexpr double kRate = 1e-6, kWanted = 0.4;
  Random random{5};
  Mlp mlp{kSizes, random};
  const auto loss = [&] {
    const double difference = mlp.evaluate(kInputs).back()[0] - kWanted;
    return difference * difference / 2;
  };
  const double before = loss();
  const std::vector<MlpLayer> old = mlp.layers();
  (void)mlp.evaluate(kInputs);
  mlp.add_gradient(kWanted);
  mlp.step(1, kRate);
  int moved = 0, stayed = 0;
  for (std::size_t l = 0; l < old.size(); ++l) {
    for (std::size_t i = 0; i < old[l].weights.size(); ++i) {
      const double change = mlp.layers()[l].weights[i] - old[l].weights[i];
      if (change == 0) {
        ++stayed;  // of a neuron that is cut
        continue;
      }
      EXPECT_NEAR(std::fabs(change), kRate, 0.1 * kRate);
      ++moved;
    }
  }
  EXPECT_GT(moved, 10);
  EXPECT_GT(stayed, 0);
  EXPECT_LT(loss(), before);
}

TEST(Mlp, LearnsAFunctionThatIsNotLinear) {
  Random random{6};
  constexpr std::array<std::size_t, 4> kShape{1, 8, 8, 1};
  Mlp mlp{kShape, random};
  const auto wanted = [](double x) { return std::fabs(x) - 0.5; };
  for (int step = 0; step < 2'000; ++step) {
    for (int i = 0; i < 16; ++i) {
      const std::array x{static_cast<double>(random.next() % 2001) / 1000 - 1};
      (void)mlp.evaluate(x);
      mlp.add_gradient(wanted(x[0]));
    }
    mlp.step(16, 1e-2 * (1 - step / 2'000.0));
  }
  for (double x = -1; x <= 1; x += 0.125) EXPECT_NEAR(mlp.evaluate(std::array{x}).back()[0], wanted(x), 0.05) << x;
}

TEST(Mlp, ComputesWithReluInTheHiddenLayersOnly) {
  Random random{7};
  Mlp mlp{kSizes, random};
  std::vector<double> values{kInputs.begin(), kInputs.end()};
  for (std::size_t l = 0; l < mlp.layers().size(); ++l) {
    const MlpLayer& layer = mlp.layers()[l];
    std::vector<double> next;
    for (std::size_t n = 0; n < layer.biases.size(); ++n) {
      long double sum = layer.biases[n];
      for (std::size_t i = 0; i < layer.inputs; ++i)
        sum += static_cast<long double>(layer.weights[n * layer.inputs + i]) * values[i];
      next.push_back(l + 1 < mlp.layers().size() && sum < 0 ? 0 : static_cast<double>(sum));
    }
    values = next;
  }
  EXPECT_NEAR(mlp.evaluate(kInputs).back()[0], values[0], 1e-12);
}

}  // namespace
}  // namespace armature::cosim
