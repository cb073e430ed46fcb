#include "cosim/cpu/core_memory.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace armature::cosim {
namespace {

const CoreMemory kMemory{.parts = {{"code", 0x1000, 0x100}, {"data", 0x2000, 0x10}},
                         .symbols = {{"first", 0x1000}, {"second", 0x1080}, {"end", 0x1100}, {"variable", 0x2008}}};

TEST(CoreMemory, FindsWordsBehindAndBeforeASymbol) {
  EXPECT_EQ(kMemory.word_at("second", 0), 0x1080U);
  EXPECT_EQ(kMemory.word_at("second", 0x7C), 0x10FCU);
  EXPECT_EQ(kMemory.word_at("variable", -8), 0x2000U);
}

TEST(CoreMemory, HasNoWordOutsideOfItsParts) {
  EXPECT_EQ(kMemory.word_at("end", 0), std::nullopt);
  EXPECT_EQ(kMemory.word_at("variable", -12), std::nullopt);
  EXPECT_EQ(kMemory.word_at("first", -0x2000), std::nullopt);
  EXPECT_EQ(kMemory.word_at("first", 0x1'0000'0000), std::nullopt);
  EXPECT_EQ(kMemory.word_at("third", 0), std::nullopt);
}

TEST(CoreMemory, NamesAPlaceByTheNearestSymbolBeforeIt) {
  using Place = std::pair<std::string, std::int64_t>;
  EXPECT_EQ(kMemory.place_of(0x1000), (Place{"first", 0}));
  EXPECT_EQ(kMemory.place_of(0x10FC), (Place{"second", 0x7C}));
  EXPECT_EQ(kMemory.place_of(0x200C), (Place{"variable", 4}));
}

}  // namespace
}  // namespace armature::cosim
