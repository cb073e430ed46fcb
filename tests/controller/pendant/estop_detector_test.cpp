#include "controller/pendant/parts/estop_detector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tests/controller/pendant/pendant_draws.hpp"

namespace armature::pendant {
namespace {

using armature::test::SplitMix;

int stops_in(const std::vector<std::uint8_t>& bytes) {
  EstopDetector detector;
  return static_cast<int>(std::ranges::count_if(bytes, [&](std::uint8_t byte) { return detector.push(byte); }));
}

TEST(EstopDetector, TakesFourBytesInARowForAnEmergencyStop) {
  EXPECT_EQ(stops_in({0xEE, 0xEE, 0xEE, 0xEE}), 1);
  EXPECT_EQ(stops_in({0xEE, 0xEE, 0xEE}), 0);
  EXPECT_EQ(stops_in({0xEE, 0xEE, 0xEE, 0x00, 0xEE}), 0);
}

TEST(EstopDetector, TakesAllBytesOfALongRunForOneEmergencyStop) {
  EXPECT_EQ(stops_in(std::vector<std::uint8_t>(kEstopBytes, kEstopByte)), 1);
}

TEST(EstopDetector, FindsTheNextEmergencyStopAfterAnotherByte) {
  EXPECT_EQ(stops_in({0xEE, 0xEE, 0xEE, 0xEE, 0x00, 0xEE, 0xEE, 0xEE, 0xEE}), 2);
}

// Payloads that consist of the byte as far as they can, in all orders of frames.
TEST(EstopDetector, FindsNoEmergencyStopInValidFrames) {
  SplitMix random{0x15E5};
  constexpr auto kMostlyStop = static_cast<std::int32_t>(0xFFEE'EEEEu);
  EstopDetector detector;
  for (int draw = 0; draw < 300'000; ++draw) {
    FrameBytes bytes = test::random_frame(random);
    if (random.below(2) == 0) {
      Frame command = test::random_command(random);
      command.payload = kMostlyStop;
      bytes = encode(command);
    }
    for (const std::uint8_t byte : bytes) ASSERT_FALSE(detector.push(byte)) << "frame " << draw;
  }
}

TEST(EstopDetector, FindsTheEmergencyStopAfterAnyBytes) {
  SplitMix random{0x15E6};
  for (int draw = 0; draw < 10'000; ++draw) {
    EstopDetector detector;
    for (std::uint32_t i = random.below(40); i > 0; --i) {
      static_cast<void>(detector.push(static_cast<std::uint8_t>(random.below(256))));
    }
    // At most the run before continues into this one, and then it has been found already or is found earlier.
    static_cast<void>(detector.push(0x00));
    int found_after = 0;
    for (int byte = 1; byte <= kEstopBytes && found_after == 0; ++byte)
      found_after = detector.push(kEstopByte) ? byte : 0;
    ASSERT_EQ(found_after, kEstopRun);
  }
}

}  // namespace
}  // namespace armature::pendant
