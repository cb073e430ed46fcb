#include <gtest/gtest.h>

#include <array>

#include "controller/policy/policy_network.hpp"

namespace armature {
namespace {

// zlib.crc32(b"123456789012") in Python.
TEST(PolicyChecksum, IsTheCrc32OfTheBytesOfTheWords) {
  constexpr std::array<std::uint32_t, 3> kDigits{0x3433'3231, 0x3837'3635, 0x3231'3039};
  EXPECT_EQ(PolicyNetwork::checksum(kDigits), 0x5D34'EB96);
  EXPECT_EQ(PolicyNetwork::checksum({}), 0u);
}

}  // namespace
}  // namespace armature
