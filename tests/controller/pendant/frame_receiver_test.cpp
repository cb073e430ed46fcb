#include "controller/pendant/protocol/frame_receiver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tests/controller/pendant/pendant_draws.hpp"
#include "tests/controller/support/draws.hpp"

namespace armature::pendant {
namespace {

using armature::test::draws;
using armature::test::SplitMix;
using Bytes = std::vector<std::uint8_t>;

std::vector<FrameBytes> received(const Bytes& bytes) {
  FrameReceiver receiver{End::kController};
  std::vector<FrameBytes> frames;
  for (const std::uint8_t byte : bytes) {
    if (const std::optional<FrameBytes> frame = receiver.push(byte)) frames.push_back(*frame);
  }
  return frames;
}

std::vector<FrameBytes> random_frames(SplitMix& random, int count) {
  std::vector<FrameBytes> frames;
  for (int i = 0; i < count; ++i) frames.push_back(test::random_frame(random));
  return frames;
}

TEST(FrameReceiver, FindsFramesThatFollowEachOther) {
  SplitMix random{0x15F1};
  const std::vector<FrameBytes> frames = random_frames(random, 1'000);
  EXPECT_EQ(received(test::stream_of(frames)), frames);
}

TEST(FrameReceiver, CompletesAFrameWithItsLastByte) {
  FrameReceiver receiver{End::kController};
  const FrameBytes frame = encode(Frame{.opcode = Opcode::kHeartbeat});
  for (std::size_t i = 0; i + 1 < frame.size(); ++i) EXPECT_EQ(receiver.push(frame[i]), std::nullopt);
  EXPECT_EQ(receiver.push(frame.back()), frame);
  EXPECT_EQ(receiver.dropped(), 0u);
}

TEST(FrameReceiver, DropsTheFrameUnderWayWhenTheLineIsSilent) {
  FrameReceiver receiver{End::kController};
  const FrameBytes frame = encode(Frame{.opcode = Opcode::kHeartbeat});
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(receiver.push(frame[i]), std::nullopt);
  receiver.discard();
  for (std::size_t i = 0; i + 1 < frame.size(); ++i) EXPECT_EQ(receiver.push(frame[i]), std::nullopt);
  EXPECT_EQ(receiver.push(frame.back()), frame);
  EXPECT_EQ(receiver.dropped(), 5u);
}

// What one kind of damage does to a stream without gaps.
struct Damage {
  std::vector<FrameBytes> frames;
  std::size_t last_hurt = 0;  // the last frame that has a damaged byte
  Bytes stream;
};

enum class Defect { kLoss, kInsertion, kFlip, kRepetition, kSwap };

Damage damaged(SplitMix& random, Defect kind, std::size_t bytes) {
  Damage damage;
  damage.frames = random_frames(random, 12);
  damage.stream = test::stream_of(damage.frames);
  const std::size_t at = 8 * 3 + random.below(8);
  const auto place = damage.stream.begin() + static_cast<std::ptrdiff_t>(at);
  const auto count = static_cast<std::ptrdiff_t>(bytes);
  damage.last_hurt = (at + bytes - 1) / kFrameBytes;
  switch (kind) {
    case Defect::kLoss:
      damage.stream.erase(place, place + count);
      break;
    case Defect::kInsertion: {
      Bytes noise(bytes);
      std::ranges::generate(noise, [&] { return static_cast<std::uint8_t>(random.below(256)); });
      damage.stream.insert(place, noise.begin(), noise.end());
      damage.last_hurt = at / kFrameBytes;
      break;
    }
    case Defect::kFlip:
      for (std::size_t i = 0; i < bytes; ++i) {
        damage.stream[at + i] = static_cast<std::uint8_t>(damage.stream[at + i] ^ 1u << random.below(8));
      }
      break;
    case Defect::kRepetition: {
      const Bytes again(place, place + count);
      damage.stream.insert(place, again.begin(), again.end());
      damage.last_hurt = at / kFrameBytes;
      break;
    }
    case Defect::kSwap:
      std::swap(damage.stream[at], damage.stream[at + bytes]);
      damage.last_hurt = (at + bytes) / kFrameBytes;
      break;
  }
  return damage;
}

// Recovery, and frames that nobody sent. The bounds of the latter are those of facts about a CRC of eight bits: of the
// windows over a splice, the filters and the CRC accept few.
TEST(FrameReceiver, ReceivesAllFramesAgainWithinThreeFramesOfAnyDamage) {
  SplitMix random{0x15F2};
  std::int64_t cases = 0, invented = 0, late = 0;
  for (const Defect kind : {Defect::kLoss, Defect::kInsertion, Defect::kFlip, Defect::kRepetition, Defect::kSwap}) {
    for (std::size_t bytes = 1; bytes <= 8; ++bytes) {
      for (int draw = 0; draw < draws(2'000); ++draw) {
        ++cases;
        const Damage damage = damaged(random, kind, bytes);
        const std::vector<FrameBytes> got = received(damage.stream);
        // The frames from the third one after the damage on must be the last ones that were received.
        const std::size_t healthy = damage.frames.size() - (damage.last_hurt + 1) - 2;
        const bool recovered =
            got.size() >= healthy && std::equal(damage.frames.end() - static_cast<std::ptrdiff_t>(healthy),
                                                damage.frames.end(), got.end() - static_cast<std::ptrdiff_t>(healthy));
        late += !recovered;
        for (const FrameBytes& frame : got) {
          invented += std::ranges::find(damage.frames, frame) == damage.frames.end();
        }
      }
    }
  }
  EXPECT_EQ(late, 0) << "of " << cases;
  EXPECT_LT(invented, cases / 300) << "of " << cases;
  RecordProperty("invented", static_cast<int>(invented));
}

// With gaps between frames, as the pendant sends commands: the damaged frame is the only one that is lost.
TEST(FrameReceiver, LosesOnlyTheDamagedFrameWhenFramesAreApart) {
  SplitMix random{0x15F3};
  for (int draw = 0; draw < draws(20'000); ++draw) {
    FrameReceiver receiver{End::kController};
    Bytes first{};
    const FrameBytes hurt = test::random_frame(random), next = test::random_frame(random);
    first.assign(hurt.begin(), hurt.end());
    first.erase(first.begin() + random.below(8));
    for (const std::uint8_t byte : first) ASSERT_EQ(receiver.push(byte), std::nullopt);
    receiver.discard();
    std::optional<FrameBytes> got;
    for (const std::uint8_t byte : next) got = receiver.push(byte);
    ASSERT_EQ(got, next);
  }
}

// A million single damaged bytes: a frame that was never sent is accepted never. (A CRC detects an error of up to eight
// consecutive bits.)
TEST(FrameReceiver, NeverAcceptsAFrameWithOneWrongByte) {
  SplitMix random{0x15F4};
  for (int draw = 0; draw < draws(1'000'000); ++draw) {
    FrameBytes bytes = test::random_frame(random);
    std::uint8_t& byte = bytes[random.below(8)];
    byte = static_cast<std::uint8_t>(byte ^ (1u + random.below(255)));
    ASSERT_FALSE(valid(bytes, End::kController));
  }
}

TEST(FrameReceiver, AcceptsAlmostNothingOfNoise) {
  SplitMix random{0x15F5};
  FrameReceiver receiver{End::kController};
  int accepted = 0;
  constexpr int kBytes = 1'000'000;
  for (int i = 0; i < kBytes; ++i) accepted += receiver.push(static_cast<std::uint8_t>(random.below(256))).has_value();
  // Of 2^64 windows: 16 sequences of each command and parameter with 2^28 payloads, and 16 * 128^6 texts; the CRC fits
  // to each.
  EXPECT_LT(accepted, 60);
}

}  // namespace
}  // namespace armature::pendant
