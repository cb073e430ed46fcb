#include "cosim/iss/elf_image.hpp"

#include <elf.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "cosim/iss/firmware.hpp"

namespace armature::cosim::iss {
namespace {

std::vector<std::uint8_t> copy_of_firmware() {
  const auto bytes = firmware();
  return {bytes.begin(), bytes.end()};
}

TEST(ElfImage, OfTheFirmwareHasItsSegmentsAndSymbols) {
  const ElfImage image{firmware()};
  ASSERT_FALSE(image.segments().empty());
  for (const ElfImage::Segment& segment : image.segments()) EXPECT_GE(segment.address, 0x0010'0000u);
  EXPECT_EQ(image.symbol("host_memory"), 0x1000'0000u);
  EXPECT_EQ(image.symbol("armature_charge") % 4, 0u) << "ARM state";
  EXPECT_THROW((void)image.symbol("no_such_name"), std::runtime_error);
}

// Any number of bytes from the start: an error, and no read beyond them.
TEST(ElfImage, OfACutFileIsRefused) {
  const auto whole = copy_of_firmware();
  for (std::size_t size = 0; size < whole.size(); size += 1 + size / 3) {
    const std::vector<std::uint8_t> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THROW(ElfImage{cut}, std::runtime_error) << size << " bytes";
  }
}

TEST(ElfImage, OfAnotherProcessorIsRefused) {
  for (const std::size_t place :
       {std::size_t{0}, std::size_t{EI_CLASS}, std::size_t{EI_DATA}, offsetof(Elf32_Ehdr, e_machine)}) {
    auto bytes = copy_of_firmware();
    bytes[place] = 0;
    EXPECT_THROW(ElfImage{bytes}, std::runtime_error) << "byte " << place;
  }
}

}  // namespace
}  // namespace armature::cosim::iss
