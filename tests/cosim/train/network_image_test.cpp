#include "cosim/train/network_image.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/policy/policy_network.hpp"

namespace armature::cosim {
namespace {

// The integers of random networks give what their doubles give, but for the rounding of weights and values.
TEST(NetworkImage, ComputesWhatTheDoublesCompute) {
  constexpr std::array<std::size_t, 4> kShape{10, 16, 16, 1};
  constexpr double kOut = 3;
  Random random{8};
  for (int network = 0; network < 10; ++network) {
    Mlp mlp{kShape, random};
    std::vector<std::array<double, 10>> inputs(200);
    for (auto& values : inputs) {
      for (double& value : values) value = (static_cast<double>(random.next() % 255) - 127) / 127;
    }
    std::array<double, 4> largest{1, 0, 0, kOut};
    for (const auto& values : inputs) {
      for (std::size_t l = 1; l < 3; ++l)
        largest[l] = std::max(largest[l], *std::ranges::max_element(mlp.evaluate(values)[l]));
    }
    const std::vector<std::uint32_t> image = network_image(mlp, largest);
    const auto decoded = PolicyNetwork::decode(image);
    ASSERT_TRUE(decoded);
    EXPECT_EQ(decoded->words(), image.size());
    double worst = 0;
    for (const auto& values : inputs) {
      std::array<std::int8_t, 10> bytes{};
      for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::int8_t>(std::lround(values[i] * 127));
      const double wanted = std::clamp(mlp.evaluate(values).back()[0] / kOut, -1.0, 1.0);
      worst = std::max(worst, std::fabs(decoded->evaluate(bytes, 127)[0] / 127.0 - wanted));
    }
    EXPECT_LT(worst, 0.04);
  }
}

}  // namespace
}  // namespace armature::cosim
