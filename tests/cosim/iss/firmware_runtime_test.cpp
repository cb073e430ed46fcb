// What the firmware computes itself instead of the libraries, on the simulated core: controller/board/runtime.cpp and
// memory.S.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

#include "cosim/iss/arm_core.hpp"
#include "cosim/iss/elf_image.hpp"
#include "cosim/iss/firmware.hpp"
#include "tests/controller/support/random.hpp"

namespace armature::cosim::iss {
namespace {

constexpr std::uint32_t kFirmware = 0x0010'0000, kEnd = 0x2000'0000, kMemory = 0x3000'0000;

class FirmwareRuntime : public testing::Test {
 protected:
  FirmwareRuntime() {
    for (const ElfImage::Segment& segment : image_.segments()) {
      const std::size_t begin = segment.address - kFirmware;
      if (code_.size() < begin + segment.bytes.size()) continue;
      std::copy(segment.bytes.begin(), segment.bytes.end(), code_.begin() + static_cast<std::ptrdiff_t>(begin));
    }
    core_.map({kFirmware, code_.data(), code_.size()});
    core_.map({kMemory, memory_.data(), memory_.size()});
    core_.write_register<std::uint32_t>(UC_ARM_REG_C1_C0_2, 0x00f0'0000);
    core_.write_register<std::uint32_t>(UC_ARM_REG_FPEXC, 0x4000'0000);
  }

  // Arguments and result in core registers.
  std::uint64_t call(std::string_view function, std::uint32_t r0, std::uint32_t r1 = 0, std::uint32_t r2 = 0) {
    core_.write_register(UC_ARM_REG_R0, r0);
    core_.write_register(UC_ARM_REG_R1, r1);
    core_.write_register(UC_ARM_REG_R2, r2);
    core_.write_register<std::uint32_t>(UC_ARM_REG_SP, kMemory + 0x8000);
    core_.write_register<std::uint32_t>(UC_ARM_REG_LR, kEnd);
    core_.prepare(image_.symbol(function), kEnd);
    return std::uint64_t{core_.read_register<std::uint32_t>(UC_ARM_REG_R1)} << 32 |
           core_.read_register<std::uint32_t>(UC_ARM_REG_R0);
  }
  std::uint64_t call_wide(std::string_view function, std::uint64_t word) {
    return call(function, static_cast<std::uint32_t>(word), static_cast<std::uint32_t>(word >> 32));
  }
  double floor(double value) {
    core_.write_register(UC_ARM_REG_D0, std::bit_cast<std::uint64_t>(value));
    call("floor", 0);
    return std::bit_cast<double>(core_.read_register<std::uint64_t>(UC_ARM_REG_D0));
  }

  ElfImage image_{firmware()};
  std::vector<std::uint8_t> code_ = std::vector<std::uint8_t>(0x20'0000);
  std::vector<std::uint8_t> memory_ = std::vector<std::uint8_t>(0x1'0000);
  ArmCore core_{0, kEnd - 4};
  test::Random random_{77};
};

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

TEST_F(FirmwareRuntime, CopiesAndSetsAnyNumberOfBytesAtAnyAddress) {
  for (std::uint32_t bytes = 0; bytes < 150; ++bytes) {
    const auto from = static_cast<std::uint32_t>(random_.integer(0, 9)), to = static_cast<std::uint32_t>(bytes % 9);
    for (std::uint8_t& byte : memory_) byte = static_cast<std::uint8_t>(random_.integer(0, 255));
    std::vector<std::uint8_t> wanted = memory_;
    std::memcpy(&wanted[0x1000 + to], &wanted[0x2000 + from], bytes);
    EXPECT_EQ(call("memcpy", kMemory + 0x1000 + to, kMemory + 0x2000 + from, bytes) & 0xFFFF'FFFF,
              kMemory + 0x1000 + to);
    ASSERT_EQ(memory_, wanted) << bytes;
    std::memset(&wanted[0x3000 + to], 0x5a, bytes);
    EXPECT_EQ(call("memset", kMemory + 0x3000 + to, 0x5a, bytes) & 0xFFFF'FFFF, kMemory + 0x3000 + to);
    ASSERT_EQ(memory_, wanted) << bytes;
  }
}

TEST_F(FirmwareRuntime, ConvertsWholeNumbersAsTheHostDoes) {
  for (int round = 0; round < 4000; ++round) {
    const std::uint64_t word = random_.bits() >> random_.integer(0, 63);
    for (const std::uint64_t number : {word, 0 - word}) {
      const auto with_sign = static_cast<std::int64_t>(number);
      ASSERT_EQ(call_wide("__aeabi_l2d", number), bits(static_cast<double>(with_sign))) << with_sign;
      ASSERT_EQ(call_wide("__aeabi_ul2d", number), bits(static_cast<double>(number))) << number;
    }
  }
}

TEST_F(FirmwareRuntime, CutsAndRoundsDownAsTheHostDoes) {
  std::vector<double> values{
      0.0, -0.0, 0.5, -0.5, 1.0, -1.0, 0x1p31, -0x1p31, 0x1p31 - 1.0, 0x1p32, 4503599627370495.5};
  for (int round = 0; round < 4000; ++round) {
    const double value = std::ldexp(random_.real(-1.0, 1.0), static_cast<int>(random_.integer(-5, 62)));
    values.insert(values.end(), {value, std::floor(value), std::ceil(value)});
  }
  for (const double value : values) {
    ASSERT_EQ(bits(floor(value)), bits(std::floor(value))) << value;
    ASSERT_EQ(call_wide("__aeabi_d2lz", bits(value)), static_cast<std::uint64_t>(static_cast<std::int64_t>(value)))
        << value;
    const double size = std::fabs(value);
    ASSERT_EQ(call_wide("__aeabi_d2ulz", bits(size)), static_cast<std::uint64_t>(size)) << value;
  }
  EXPECT_EQ(floor(std::numeric_limits<double>::infinity()), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(floor(std::numeric_limits<double>::quiet_NaN())));
}

}  // namespace
}  // namespace armature::cosim::iss
