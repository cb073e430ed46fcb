// What files hold, as terminals, logs and messages get it.
#include "cosim/text/printable.hpp"

#include <gtest/gtest.h>

#include <string>

#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

using namespace std::string_literals;

TEST(Printable, KeepsLettersOfAnyLanguage) {
  for (const std::string text : {"plain \"text\" with \\ and %", "\u00e4\u00f6\u00fc \u00df \u00c5",
                                 "\u03b1\u03b2\u03b3", "\u624b\u81c2", "\U0001F9BE", "\u200d\ufeff", ""}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, EscapesWhatATerminalObeys) {
  EXPECT_EQ(printable("a\nb\r\tc"), "a\\nb\\r\\tc");
  EXPECT_EQ(printable("\x1b[31mred\x07\x7f"), "\\x1B[31mred\\x07\\x7F");
  EXPECT_EQ(printable("nul\0!"s), "nul\\x00!");
  EXPECT_EQ(printable("\u0080\u009b31m\u009f\u00a0"), "\\u0080\\u009B31m\\u009F\u00a0");
  EXPECT_EQ(printable("\u2028\u202e\u2066"), "\\u2028\\u202E\\u2066");
}

TEST(Printable, EscapesEachByteThatIsNoUtf8) {
  EXPECT_EQ(printable("\xff\xfe"), "\\xFF\\xFE");
  EXPECT_EQ(printable("a\x80z"), "a\\x80z");
  EXPECT_EQ(printable("\xc3"), "\\xC3") << "cut off";
  EXPECT_EQ(printable("\xe2\x82"), "\\xE2\\x82");
  EXPECT_EQ(printable("\xc0\xaf"), "\\xC0\\xAF") << "too long form of a slash";
  EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xE0\\x80\\xAF");
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xED\\xA0\\x80") << "surrogate";
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xF4\\x90\\x80\\x80") << "above U+10FFFF";
  EXPECT_EQ(printable("\xf0\x8f\xbf\xbf"), "\\xF0\\x8F\\xBF\\xBF");
  EXPECT_EQ(printable("\xef\xbf\xbe\xef\xbf\xbf"), "\\uFFFE\\uFFFF") << "no characters";
}

TEST(Printable, ChangesNothingWhenItIsAppliedTwice) {
  const std::string once = printable("\x1b \xff \u202e \\ \n");
  EXPECT_EQ(printable(once), once);
}

TEST(Printable, CutsAndTellsIt) {
  const std::string longest(kMaxShown, 'x');
  EXPECT_EQ(printable(longest), longest);
  EXPECT_EQ(printable(longest + "x"), longest + "[...]");
  EXPECT_EQ(printable("\u00e4\u00f6\u00fc", 2), "\u00e4\u00f6[...]") << "characters, not bytes";
  EXPECT_EQ(printable("ab\x1b", 5), "ab[...]") << "no half escape";
  EXPECT_EQ(printable(longest + longest, kShowAll), longest + longest);
}

TEST(Printable, KeepsTheLinesOfATextOfLines) {
  EXPECT_EQ(printable_lines("a\x1b\n\nb\r\n"), "a\\x1B\n\nb\\r\n");
  EXPECT_EQ(printable_lines("\n"), "\n");
  EXPECT_EQ(printable_lines(""), "");
}

TEST(Problem, IsOnePrintableLine) {
  const Problem problem{"a\nb.toml", Origin{3, 4, {}}, "k\x1b", "found \"\xff\""};
  EXPECT_EQ(problem.text(), "a\\nb.toml:3:4: k\\x1B: found \"\\xFF\"");
  const Problem of_override{"", Origin{0, 0, "k=\x1b"}, "", "m"};
  EXPECT_EQ(of_override.text(), "--set k=\\x1B: m");
  const Problem long_key{"f", Origin{1, 1, {}}, std::string(10'000, 'k'), std::string(10'000, 'm')};
  EXPECT_LT(long_key.text().size(), 2300u);
}

TEST(ProblemList, KeepsTheFirstAndCountsTheOthers) {
  ProblemList list{"f"};
  for (int i = 1; i <= 250; ++i) list.add(Origin{i, 1, {}}, "k", "m");
  EXPECT_EQ(list.size(), 250u);
  std::vector<Problem> all;
  list.move_to(all);
  ASSERT_EQ(all.size(), ProblemList::kMaxKept + 1);
  EXPECT_EQ(all.front().text(), "f:1:1: k: m");
  EXPECT_EQ(all.back().text(), "f: and 150 more problems");
}

}  // namespace
}  // namespace armature::cosim
