#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "cosim/text/suggest.hpp"

namespace armature::cosim {
namespace {

constexpr std::array<std::string_view, 4> kKnown{"target_deg", "at_s", "speed_percent", "type"};

TEST(Suggest, FindsSpellingMistakesAndWrongUnits) {
  EXPECT_EQ(nearest_name("traget_deg", kKnown), "target_deg");
  EXPECT_EQ(nearest_name("TYPE", kKnown), "type");
  EXPECT_EQ(nearest_name("target", kKnown), "target_deg");
  EXPECT_EQ(nearest_name("target_mm", kKnown), "target_deg");
  EXPECT_EQ(nearest_name("at", kKnown), "at_s");
  EXPECT_EQ(nearest_name("tpye", kKnown), "type");
}

TEST(Suggest, IsSilentAboutWhatIsNotNear) {
  EXPECT_EQ(nearest_name("wallpaper", kKnown), "");
  EXPECT_EQ(nearest_name("", kKnown), "");
  EXPECT_EQ(suggestion("wallpaper", kKnown), "; known: target_deg, at_s, speed_percent, type");
  EXPECT_EQ(suggestion("x", std::vector<std::string>{}), "");
}

}  // namespace
}  // namespace armature::cosim
