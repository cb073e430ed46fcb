#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "controller/pendant/protocol/crc32.hpp"
#include "controller/pendant/protocol/crc8.hpp"
#include "controller/pendant/protocol/frame.hpp"

namespace armature::pendant {
namespace {

constexpr std::string_view kCheckText = "123456789";

std::vector<std::uint8_t> bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

// The remainder of a codeword in the ring of polynomials, bit by bit: independent of the table.
std::uint8_t remainder_of(std::uint64_t codeword) {
  for (int bit = 63; bit >= 8; --bit) {
    if ((codeword >> bit & 1u) != 0) codeword ^= std::uint64_t{0x12F} << (bit - 8);
  }
  return static_cast<std::uint8_t>(codeword);
}

TEST(PendantCrc8, HasTheCheckValueOfItsStandard) {
  EXPECT_EQ(crc8(bytes_of(kCheckText)), 0xDF);
}

// The CRC is linear, so an error is undetected exactly when its pattern is a multiple of the polynomial.
TEST(PendantCrc8, DetectsEveryErrorOfOneTwoOrThreeBitsOfAFrame) {
  constexpr std::uint64_t kOne = 1;
  int undetected = 0;
  for (int a = 0; a < 64; ++a) {
    undetected += remainder_of(kOne << a) == 0;
    for (int b = a + 1; b < 64; ++b) {
      undetected += remainder_of(kOne << a | kOne << b) == 0;
      for (int c = b + 1; c < 64; ++c) undetected += remainder_of(kOne << a | kOne << b | kOne << c) == 0;
    }
  }
  EXPECT_EQ(undetected, 0);
}

TEST(PendantCrc8, MissesSomeErrorOfFourBitsSoTheDistanceIsExactlyFour) {
  constexpr std::uint64_t kOne = 1;
  int undetected = 0;
  for (int a = 0; a < 64; ++a) {
    for (int b = a + 1; b < 64; ++b) {
      for (int c = b + 1; c < 64; ++c) {
        for (int d = c + 1; d < 64; ++d) {
          undetected += remainder_of(kOne << a | kOne << b | kOne << c | kOne << d) == 0;
        }
      }
    }
  }
  EXPECT_GT(undetected, 0);
}

// Through the code that receives: all errors of up to three bits of one frame.
TEST(PendantCrc8, ReceivedFramesWithUpToThreeWrongBitsAreInvalid) {
  const FrameBytes good = encode(Frame{.sequence = 2, .opcode = Opcode::kEcho, .parameter = 5, .payload = 12'345});
  ASSERT_TRUE(valid(good, End::kController));
  const auto flipped = [](FrameBytes bytes, std::size_t bit) {
    bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ 1u << bit % 8);
    return bytes;
  };
  int accepted = 0;
  for (std::size_t a = 0; a < 64; ++a) {
    const FrameBytes one = flipped(good, a);
    accepted += valid(one, End::kController);
    for (std::size_t b = a + 1; b < 64; ++b) {
      const FrameBytes two = flipped(one, b);
      accepted += valid(two, End::kController);
      for (std::size_t c = b + 1; c < 64; ++c) accepted += valid(flipped(two, c), End::kController);
    }
  }
  EXPECT_EQ(accepted, 0);
}

TEST(PendantCrc32, HasTheCheckValueOfItsStandard) {
  Crc32 crc;
  for (const std::uint8_t byte : bytes_of(kCheckText)) crc.add(byte);
  EXPECT_EQ(crc.value(), 0xCBF4'3926u);
  EXPECT_EQ(crc.check(), 0x03F4'3926);
}

TEST(PendantCrc32, TakesNumbersLowestByteFirst) {
  Crc32 bytes, number;
  for (const std::uint8_t byte : std::initializer_list<std::uint8_t>{0x78, 0x56, 0x34, 0xF2}) bytes.add(byte);
  number.add(static_cast<std::int32_t>(0xF234'5678u));
  EXPECT_EQ(number.value(), bytes.value());
}

}  // namespace
}  // namespace armature::pendant
