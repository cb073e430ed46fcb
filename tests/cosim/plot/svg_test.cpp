#include "cosim/plot/svg.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/plot/caption.hpp"

namespace armature::cosim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(SvgPicture, TextOfAUserIsNoMarkup) {
  SvgPicture picture{100, 50, "</title><script>alert(1)</script>"};
  picture.text({1, 2}, "<b onload=\"x\">&amp;\x1b[31m", {});
  EXPECT_THAT(picture.document(), Not(HasSubstr("<script")));
  EXPECT_THAT(picture.document(), Not(HasSubstr("<b ")));
  EXPECT_THAT(picture.document(), HasSubstr("&lt;b onload=&quot;x&quot;&gt;&amp;amp;\\x1B[31m"));
}

TEST(SvgPicture, CoordinatesHaveTwoDigitsAndNoMinusZero) {
  SvgPicture picture{100, 50, "t"};
  picture.polyline({{-0.001, 1.006}, {10, 2.5}}, {.color = "red"});
  EXPECT_THAT(picture.document(), HasSubstr(R"(points="0,1.01 10,2.5")"));
}

TEST(Caption, BreaksALongTitleAtBlanks) {
  EXPECT_THAT(wrapped("one two three", 7), ElementsAre("one two", "three"));
  EXPECT_THAT(wrapped("\u00e4\u00f6 \u00fc\u00df", 5), ElementsAre("\u00e4\u00f6 \u00fc\u00df"));
  EXPECT_THAT(wrapped("  immeasurable  x", 4), ElementsAre("immeasurable", "x"));
  EXPECT_THAT(wrapped("", 4), ElementsAre());
}

}  // namespace
}  // namespace armature::cosim
