// The guard of the network's corrections with the model of the block: every fault gives a correction of 0 and a count.
#include "controller/policy/policy_guard.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "controller/policy/policy_network.hpp"
#include "cosim/model/policy_mlp/policy_mlp.hpp"
#include "tests/controller/support/mock_register_bus.hpp"
#include "tests/controller/support/policy_block_bus.hpp"
#include "tests/support/mlp_images.hpp"

namespace armature {
namespace {

class PolicyGuardTest : public testing::Test {
 protected:
  static constexpr std::int64_t kTick = 2'500;
  static constexpr std::uint8_t kShare = 40;

  PolicyGuardTest() {
    test::RandomNetworks networks{3751};
    image_ = test::image_of(networks.of({4, 16, 3}), 8);
    cosim::model::mlp::Memory memory{};
    std::copy(image_.begin(), image_.end(), memory.begin());
    crc_ = cosim::model::mlp::evaluate(memory, 8, {}).crc;
  }
  // A tick: the correction of the last request, and a new request.
  PolicyScale::Correction tick(const std::vector<double>& observation, std::int64_t clocks = kTick) {
    const auto correction = guard_.collect();
    guard_.request(observation);
    bus_.pass(clocks);
    return correction;
  }

  static PolicyScale make_scale() {
    PolicyScale scale{.input_count = 4, .output_count = 3};
    for (auto& range : scale.inputs) range = {-1, 1};
    scale.full_output = {127, 254, 12.7};
    return scale;
  }

  test::PolicyBlockBus bus_;
  PolicyScale scale_ = make_scale();
  test::TestImage image_;
  std::uint32_t crc_ = 0;
  PolicyGuard guard_{bus_, scale_, kShare};
};

TEST_F(PolicyGuardTest, ACorrectionIsThatOfTheNetworkInSoftwareWithinTheBound) {
  ASSERT_TRUE(guard_.start(image_, crc_));
  const auto network = PolicyNetwork::decode(image_);
  ASSERT_TRUE(network);
  test::SplitMix random{3752};
  std::vector<double> before;
  int at_the_bound = 0;
  for (int i = 0; i < 50; ++i) {
    std::vector<double> observation(4);
    for (double& value : observation) value = random.below(2001) / 1000.0 - 1;
    const auto correction = tick(observation);
    if (before.empty()) {
      EXPECT_EQ(correction, PolicyScale::Correction{});
    } else {
      const auto bytes = scale_.quantised(before);
      ASSERT_TRUE(bytes);
      EXPECT_EQ(correction, scale_.correction(network->evaluate(*bytes, kShare)));
      at_the_bound += std::abs(correction[0]) == kShare;
      EXPECT_LE(std::abs(correction[1]), 2 * kShare);
    }
    before = observation;
  }
  EXPECT_EQ(guard_.counts().used, 49u);
  EXPECT_GT(at_the_bound, 0);
}

TEST_F(PolicyGuardTest, ALateResultIsNotUsedAndCounted) {
  ASSERT_TRUE(guard_.start(image_, crc_));
  tick({0.5, 0.5, 0.5, 0.5}, 20);
  EXPECT_EQ(tick({0.5, 0.5, 0.5, 0.5}), PolicyScale::Correction{});
  EXPECT_EQ(guard_.counts().late, 1u);
  EXPECT_EQ(tick({0.5, 0.5, 0.5, 0.5}), PolicyScale::Correction{}) << "of the observation of two ticks ago";
  EXPECT_EQ(guard_.counts().used, 0u);
  tick({0.5, 0.5, 0.5, 0.5});
  EXPECT_EQ(guard_.counts().used, 1u);
  EXPECT_EQ(guard_.counts().late, 1u);
}

TEST_F(PolicyGuardTest, AnObservationOutsideTheRangesHasNoCorrection) {
  ASSERT_TRUE(guard_.start(image_, crc_));
  tick({0.5, 1.001, 0.5, 0.5});
  EXPECT_EQ(tick({0.5, 0.5, 0.5, 0.5}), PolicyScale::Correction{});
  EXPECT_EQ(guard_.counts().out_of_range, 1u);
  tick({0.5, 0.5, 0.5, 0.5});
  EXPECT_EQ(guard_.counts().used, 1u);
}

TEST_F(PolicyGuardTest, EachFlippedBitOfTheImageGivesNoCorrection) {
  test::SplitMix random{3753};
  constexpr std::uint32_t kFlips = 50;
  for (std::uint32_t i = 0; i < kFlips; ++i) {
    test::TestImage flipped = image_;
    flipped[random.below(static_cast<std::uint32_t>(image_.size()))] ^= 1u << random.below(32);
    ASSERT_TRUE(guard_.start(flipped, crc_));
    tick({0.5, -0.5, 0.5, 0.5});
    EXPECT_EQ(guard_.collect(), PolicyScale::Correction{});
  }
  EXPECT_EQ(guard_.counts().invalid, kFlips);
  EXPECT_EQ(guard_.counts().used, 0u);
}

TEST_F(PolicyGuardTest, LoadsAnImageInPartsAndAnswersOnlyThen) {
  constexpr std::size_t kWords = 8;
  const std::size_t parts = (image_.size() + kWords - 1) / kWords;
  for (std::size_t part = 1; part < parts; ++part) {
    ASSERT_FALSE(guard_.load(image_, crc_, kWords)) << part;
    EXPECT_EQ(tick({0.5, -0.5, 0.5, 0.5}), PolicyScale::Correction{});
  }
  ASSERT_TRUE(guard_.load(image_, crc_, kWords));
  tick({0.5, -0.5, 0.5, 0.5});
  const auto in_parts = guard_.collect();
  EXPECT_EQ(guard_.counts().used, 1u);
  ASSERT_TRUE(guard_.start(image_, crc_));
  tick({0.5, -0.5, 0.5, 0.5});
  EXPECT_EQ(guard_.collect(), in_parts);
}

TEST(PolicyGuardWithoutABlock, HasNoCorrection) {
  testing::StrictMock<test::MockRegisterBus> bus;
  EXPECT_CALL(bus, read32(RegAddr{0x43C5'0000})).WillOnce(testing::Return(0u));
  PolicyGuard guard{bus, PolicyScale{}, 127};
  EXPECT_FALSE(guard.start({}, 0));
  guard.request({});
  EXPECT_EQ(guard.collect(), PolicyScale::Correction{});
}

}  // namespace
}  // namespace armature
