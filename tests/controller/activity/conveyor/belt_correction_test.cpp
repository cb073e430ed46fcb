// The network that corrects a belt: in the logic and in software, with right and wrong weights.
#include "controller/activity/conveyor/belt_correction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/controller/support/policy_block_bus.hpp"
#include "tests/support/mlp_images.hpp"

namespace armature {
namespace {

constexpr std::int64_t kTick = 2'500;
constexpr double kFull_mm = 0.25;
constexpr std::uint8_t kShare = 100;
using Where = BeltPolicyConfig::Where;

// With random weights.
BeltPolicyConfig random_network(test::RandomNetworks& networks) {
  const test::TestImage image = test::image_of(networks.of({BeltPolicyConfig::kInputs, 16, 16, 1}), 8);
  BeltPolicyConfig config{.full_mm = kFull_mm,
                          .share = kShare,
                          .crc = PolicyNetwork::checksum(image),
                          .words = static_cast<std::uint32_t>(image.size())};
  std::copy(image.begin(), image.end(), config.image.begin());
  return config;
}

// Values of -1..1, of which some are outside of it.
BeltObservation::Values random_observation(test::SplitMix& random, std::uint32_t outside_of_10) {
  BeltObservation::Values values{};
  for (double& value : values) value = random.below(2001) / 1000.0 - 1;
  if (random.below(10) < outside_of_10) values[random.below(values.size())] = 1.01;
  return values;
}

struct Answers {
  std::vector<double> corrections_mm;
  PolicyGuard::Counts counts;
};

Answers answers_of(BeltPolicyConfig config, Where where, std::uint64_t seed, std::uint32_t outside_of_10 = 0) {
  constexpr int kTicks = 100;
  config.where = where;
  test::PolicyBlockBus bus;
  BeltCorrection correction{bus, config};
  test::SplitMix random{seed};
  Answers answers;
  for (int i = 0; i < kTicks; ++i) {
    answers.corrections_mm.push_back(correction.collect());
    correction.request(random_observation(random, outside_of_10));
    bus.pass(kTick);
  }
  answers.counts = correction.counts();
  return answers;
}

TEST(BeltCorrection, IsTheSameInTheLogicAndInSoftware) {
  test::RandomNetworks networks{4401};
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const BeltPolicyConfig config = random_network(networks);
    const Answers logic = answers_of(config, Where::kLogic, seed, 2), arm = answers_of(config, Where::kArm, seed, 2);
    EXPECT_EQ(logic.corrections_mm, arm.corrections_mm);
    EXPECT_EQ(logic.counts.used, arm.counts.used);
    EXPECT_EQ(logic.counts.out_of_range, arm.counts.out_of_range);
    EXPECT_GT(logic.counts.used, 40u);
    EXPECT_GT(logic.counts.out_of_range, 5u);
    EXPECT_EQ(logic.counts.late + logic.counts.invalid + arm.counts.late + arm.counts.invalid, 0u);
  }
}

// A campaign of weights: whatever they are, the bound holds.
TEST(BeltCorrection, NeverExceedsTheBoundWhateverTheWeights) {
  constexpr double kBound_mm = kFull_mm * kShare / 127.0;
  test::RandomNetworks networks{4402};
  double largest = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    BeltPolicyConfig config = random_network(networks);
    for (int flips = 0; flips < 20; ++flips) {  // of weights whose checksum then is right
      config.image[2 + networks.random().below(config.words - 2)] ^= 1u << networks.random().below(32);
    }
    config.crc = PolicyNetwork::checksum(std::span{config.image}.first(config.words));
    for (const Where where : {Where::kLogic, Where::kArm}) {
      for (const double mm : answers_of(config, where, seed).corrections_mm) largest = std::max(largest, std::fabs(mm));
    }
  }
  EXPECT_EQ(largest, kBound_mm);
}

TEST(BeltCorrection, IsNoneWhenABitOfTheNetworkHasFlipped) {
  test::RandomNetworks networks{4403};
  const BeltPolicyConfig good = random_network(networks);
  for (int i = 0; i < 10; ++i) {
    BeltPolicyConfig flipped = good;
    flipped.image[networks.random().below(good.words)] ^= 1u << networks.random().below(32);
    for (const Where where : {Where::kLogic, Where::kArm}) {
      const Answers answers = answers_of(flipped, where, 1);
      EXPECT_EQ(answers.corrections_mm, std::vector<double>(answers.corrections_mm.size()));
      EXPECT_EQ(answers.counts.used, 0u);
      EXPECT_GT(answers.counts.invalid, 50u);
    }
  }
}

// The statement of conveyor_belt.hpp: no sequence of corrections moves the expected belt by more than the largest one.
TEST(BeltCorrection, MovesTheExpectedBeltByNoMoreThanTheBound) {
  constexpr double kAhead_s = 0.0054;
  test::SplitMix random{4404};
  double largest = 0;
  for (int run = 0; run < 20; ++run) {
    ConveyorBelt plain{0.05, kAhead_s}, corrected{0.05, kAhead_s};
    double correction_mm = kFull_mm;
    const std::uint32_t often = 1 + random.below(2'000);
    for (std::int64_t tick = 0; tick < 4'000; ++tick) {
      const auto counts = static_cast<std::int64_t>(std::floor(static_cast<double>(tick * tick) * 1e-5));
      plain.sample(counts, Ticks{tick});
      corrected.sample(counts, Ticks{tick}, correction_mm);
      largest = std::max(largest, std::fabs(corrected.expected().position - plain.expected().position));
      if (random.below(often) == 0) correction_mm = random.below(2) == 0 ? kFull_mm : -kFull_mm;
    }
  }
  EXPECT_LE(largest, kFull_mm * (1 + 1e-12));
  EXPECT_GT(largest, 0.99 * kFull_mm);
}

TEST(BeltObservation, HasMeansOverWholePeriodsOfACamera) {
  const BeltCamera camera{.period = Ticks{400}};
  ConveyorBelt belt{0.05, 0.0, ConveyorBelt::bandwidths_for(camera)};
  BeltObservation observation{camera};
  double shortest = 0, longest = 0;
  for (std::int64_t sample = 0; sample < 100; ++sample) {
    belt.measure(sample * sample, Ticks{400 * sample});
    observation.add(belt);
    shortest += (belt.error_mm() - shortest) / 2;  // over one period
    longest += (belt.error_mm() - longest) / 37;   // over 36
    EXPECT_NEAR(observation.values()[0], shortest, 1e-12);
    EXPECT_NEAR(observation.values()[7], longest, 1e-12);
  }
}

TEST(BeltObservation, HasMeansOfTheErrorOfThePrediction) {
  ConveyorBelt belt{0.05, 0.0};
  BeltObservation observation;
  std::array<long double, BeltObservation::kMean_s.size()> mean{};
  for (std::int64_t tick = 0; tick < 500; ++tick) {
    belt.sample(tick / 7, Ticks{tick});
    observation.add(belt);
    for (std::size_t i = 0; i < mean.size(); ++i) {
      const long double share = 50e-6L / (static_cast<long double>(BeltObservation::kMean_s[i]) + 50e-6L);
      mean[i] = (1 - share) * mean[i] + share * static_cast<long double>(belt.error_mm());
      EXPECT_NEAR(observation.values()[i], static_cast<double>(mean[i]), 1e-12);
    }
  }
  EXPECT_EQ(observation.values()[8], belt.accel_mm_s2());
  EXPECT_EQ(observation.values()[9], belt.velocity_mm_s());
  EXPECT_GT(belt.velocity_mm_s(), 100.0);
}

}  // namespace
}  // namespace armature
