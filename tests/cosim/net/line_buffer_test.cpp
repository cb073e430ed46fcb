#include "cosim/net/line_buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

constexpr std::size_t kLongest = 10;

std::vector<std::string> lines_of(LineBuffer& buffer) {
  std::vector<std::string> lines;
  while (const auto line = buffer.next()) lines.push_back(line->too_long ? "<long>" : std::string{line->text});
  return lines;
}

TEST(LineBuffer, GivesNothingBeforeTheEndOfALine) {
  LineBuffer buffer{kLongest};
  EXPECT_FALSE(buffer.next());
  buffer.append("ti");
  EXPECT_FALSE(buffer.next());
  buffer.append("me");
  EXPECT_FALSE(buffer.next());
  buffer.append("\n\nx");
  EXPECT_EQ(lines_of(buffer), (std::vector<std::string>{"time", ""}));
  buffer.append("\n");
  EXPECT_EQ(lines_of(buffer), (std::vector<std::string>{"x"}));
}

TEST(LineBuffer, TheLongestLineIsTakenAndOneByteMoreIsNot) {
  for (const std::size_t chunk : {std::size_t{1}, std::size_t{3}, std::size_t{100}}) {
    LineBuffer buffer{kLongest};
    const std::string text = "aaaaaaaaaa\nbbbbbbbbbbb\nc\n";
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size(); at += chunk) {
      buffer.append(std::string_view{text}.substr(at, chunk));
      for (std::string& line : lines_of(buffer)) lines.push_back(std::move(line));
    }
    EXPECT_EQ(lines, (std::vector<std::string>{"aaaaaaaaaa", "<long>", "c"})) << chunk;
  }
}

TEST(LineBuffer, ForgetsALineThatIsTooLongWhileItArrives) {
  LineBuffer buffer{kLongest};
  for (int i = 0; i < 100; ++i) {
    buffer.append("12345");
    EXPECT_FALSE(buffer.next());
    EXPECT_LE(buffer.held(), kLongest + 5);
  }
  buffer.append("\nok\n");
  EXPECT_EQ(lines_of(buffer), (std::vector<std::string>{"<long>", "ok"}));
  EXPECT_EQ(buffer.held(), 0u);
}

TEST(LineBuffer, CutsTheSameLinesHoweverTheBytesArrive) {
  constexpr std::uint64_t kSeed = 4;
  SCOPED_TRACE(kSeed);
  armature::test::SplitMix random{kSeed};
  for (int round = 0; round < 2000; ++round) {
    std::string text;
    std::vector<std::string> expected;
    const std::uint32_t count = random.below(8);
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::string line(random.below(2 * kLongest), static_cast<char>('a' + random.below(26)));
      expected.push_back(line.size() > kLongest ? "<long>" : line);
      text += line + "\n";
    }
    text += std::string(random.below(2 * kLongest), 'z');  // no line
    LineBuffer buffer{kLongest};
    std::vector<std::string> got;
    while (!text.empty()) {
      const std::size_t size = std::min<std::size_t>(text.size(), 1 + random.below(15));
      buffer.append(text.substr(0, size));
      text.erase(0, size);
      if (random.below(2) == 0) continue;
      for (std::string& line : lines_of(buffer)) got.push_back(std::move(line));
    }
    for (std::string& line : lines_of(buffer)) got.push_back(std::move(line));
    ASSERT_EQ(got, expected) << "round " << round;
  }
}

}  // namespace
}  // namespace armature::cosim
