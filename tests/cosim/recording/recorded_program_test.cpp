#include "cosim/recording/recorded_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "cosim/text/sha256.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using test::TempFolder;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

// A run that executed these files of the folder; `digest` of the last one.
Json summary_of(const TempFolder& folder, const std::vector<std::string>& files, const std::string& digest) {
  const std::filesystem::path at = folder.write("scenario.toml", "").parent_path();
  Json summary = {{"inputs", Json::array({{{"file", (at / "scenario.toml").string()}, {"sha256", ""}}})},
                  {"result", {{"program", Json::array()}}}};
  for (const std::string& file : files) {
    summary["inputs"].push_back({{"file", (at / "." / file).string()}, {"sha256", digest}});
    for (int line = 1; line < 3; ++line) summary["result"]["program"].push_back({{"line", line}, {"file", file}});
  }
  return summary;
}

TEST(RecordedProgram, HasTheTextOfEachExecutedFileOnce) {
  const TempFolder folder;
  (void)folder.write("a.ngc", "G1 X1\n");
  (void)folder.write("b.ngc", "G1 X1\n");
  const auto programs = recorded_programs(summary_of(folder, {"b.ngc", "a.ngc"}, sha256_hex("G1 X1\n")));
  ASSERT_EQ(programs.size(), 2U);
  EXPECT_EQ(programs[0].name, "b.ngc");
  EXPECT_EQ(programs[1].text, "G1 X1\n");
  EXPECT_EQ(programs[1].problem, "");
}

TEST(RecordedProgram, AnotherTextThanThatOfTheRunIsNotShown) {
  const TempFolder folder;
  (void)folder.write("a.ngc", "G1 X2\n");
  const auto programs = recorded_programs(summary_of(folder, {"a.ngc", "b.ngc"}, sha256_hex("G1 X1\n")));
  ASSERT_EQ(programs.size(), 2U);
  EXPECT_THAT(programs[0].problem, HasSubstr("has changed"));
  EXPECT_EQ(programs[0].text, "");
  EXPECT_THAT(programs[1].problem, HasSubstr("no longer there"));
}

TEST(RecordedProgram, ARunWithoutAProgramHasNone) {
  EXPECT_TRUE(recorded_programs({{"inputs", Json::array()}, {"result", Json::object()}}).empty());
}

}  // namespace
}  // namespace armature::cosim
