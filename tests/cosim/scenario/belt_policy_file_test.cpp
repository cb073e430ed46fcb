#include "cosim/scenario/files/belt_policy_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace armature::cosim {
namespace {

std::string inputs(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += "input -" + std::to_string(i + 1) + " 0.5\n";
  return text;
}

std::string problem_of(const std::string& text) {
  try {
    (void)parse_belt_policy(text, "n");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(BeltPolicyFile, HasRangesChecksumAndImage) {
  const BeltPolicyConfig config = parse_belt_policy(
      "# a comment\nfull_mm 0.25 # mm\n" + inputs(10) + "crc 00ab01ff\nimage 00000001 ffffffff\r\n\nimage 12345678",
      "n");
  EXPECT_EQ(config.full_mm, 0.25);
  EXPECT_EQ(config.inputs[9].low, -10);
  EXPECT_EQ(config.inputs[9].high, 0.5);
  EXPECT_EQ(config.crc, 0xAB01FFu);
  EXPECT_EQ(config.words, 3u);
  EXPECT_EQ(config.image[1], 0xFFFF'FFFFu);
  EXPECT_EQ(config.image[2], 0x1234'5678u);
  EXPECT_EQ(config.misfit(), nullptr);
}

TEST(BeltPolicyFile, NamesTheLineOfWhatIsWrong) {
  std::string long_image = "image";
  for (int i = 0; i < 257; ++i) long_image += " 00000000";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"full 1", "n:1: expected full_mm, input, crc or image, found \"full\""},
      {"\nfull_mm x", "n:2: expected a number, found \"x\""},
      {"full_mm", "n:1: expected a number, found \"\""},
      {"full_mm -1", "n:1: expected a number, found \"-1\""},
      {"full_mm nan", "n:1: expected a number, found \"nan\""},
      {"full_mm 1 2", "n:1: unexpected \"2\""},
      {"input 1 1", "n:1: expected a range that ascends"},
      {inputs(11), "n:11: too many inputs"},
      {"crc 123", "n:1: expected 8 hexadecimal digits, found \"123\""},
      {"image 0000000g", "n:1: expected 8 hexadecimal digits, found \"0000000g\""},
      {long_image, "n:1: the image is too long"},
      {"", "n: has no full_mm"},
      {"full_mm 1\n" + inputs(9), "n: has no 10 lines \"input\""},
      {"full_mm 1\n" + inputs(10), "n: has no crc"},
      {"full_mm 1\n" + inputs(10) + "crc 00000000", "n: has no image"},
  };
  for (const auto& [text, problem] : cases) EXPECT_EQ(problem_of(text), problem) << text;
}

}  // namespace
}  // namespace armature::cosim
