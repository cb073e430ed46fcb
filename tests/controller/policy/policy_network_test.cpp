// The network in software against plain arithmetic and against the model of the block.
#include "controller/policy/policy_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "cosim/model/policy_mlp/network_run.hpp"
#include "tests/support/mlp_images.hpp"

namespace armature {
namespace {

namespace mlp = cosim::model::mlp;

TEST(PolicyNetwork, HasTheBitsOfPlainArithmeticAndOfTheBlock) {
  test::RandomNetworks networks{3741};
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    const test::TestNetwork plain = networks.next();
    const test::TestImage image = test::image_of(plain, 8);
    const auto network = PolicyNetwork::decode(image);
    ASSERT_TRUE(network);
    EXPECT_EQ(network->layers(), plain.size());
    EXPECT_EQ(network->words(), image.size());
    const std::vector<std::int8_t> inputs = networks.inputs(plain[0].neurons[0].weights.size());
    const auto outputs = network->evaluate(inputs, 127);
    const std::vector<std::int8_t> expected = test::outputs_of(plain, inputs);
    mlp::Memory memory{};
    std::ranges::copy(image, memory.begin());
    mlp::Inputs bytes{};
    std::ranges::copy(inputs, bytes.begin());
    const mlp::Outcome block = mlp::evaluate(memory, 8, bytes);
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      EXPECT_EQ(outputs[k], k < expected.size() ? std::max<int>(expected[k], -127) : 0) << k;
      EXPECT_EQ(outputs[k], std::max<int>(block.outputs[k], -127)) << k;
    }
  }
}

TEST(PolicyNetwork, NoOutputExceedsTheBound) {
  test::RandomNetworks networks{3742};
  for (int i = 0; i < 50; ++i) {
    const test::TestNetwork plain = networks.next();
    const test::TestImage image = test::image_of(plain, 8);
    const auto network = PolicyNetwork::decode(image);
    ASSERT_TRUE(network);
    const auto bound = static_cast<std::uint8_t>(networks.random().below(256));
    const auto outputs = network->evaluate(networks.inputs(32), bound);
    for (const std::int8_t output : outputs) EXPECT_LE(std::abs(output), std::min<int>(bound, 127));
  }
}

TEST(PolicyNetwork, ReadsNeitherAFifthLayerNorAnImageWithoutItsEnd) {
  test::RandomNetworks networks{3743};
  EXPECT_TRUE(PolicyNetwork::decode(test::image_of(networks.of({3, 3, 3, 3, 3}), 8)));
  EXPECT_FALSE(PolicyNetwork::decode(test::image_of(networks.of({3, 3, 3, 3, 3, 3}), 8)));
  test::TestImage image = test::image_of(networks.of({9, 4, 2}), 8);
  for (; !image.empty(); image.pop_back()) {
    EXPECT_EQ(PolicyNetwork::decode(image).has_value(), image.size() == 2 + 4 * 6 + 2 + 2 * 4);
  }
  EXPECT_FALSE(PolicyNetwork::decode({}));
}

}  // namespace
}  // namespace armature
