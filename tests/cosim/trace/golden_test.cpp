#include "cosim/golden/golden.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using test::read_file;
using test::TempFolder;
using testing::HasSubstr;

const std::string kOld(64, 'a');
const std::string kNew(64, 'b');

TEST(GoldenEdit, ReplacesTheDigestAndNothingElse) {
  const std::string before = "# é first\nx = 1\n[golden]  # kept\n  sha256 = \"" + kOld + "\"  # and this\n[z]\ny = 2";
  const std::string after = "# é first\nx = 1\n[golden]  # kept\n  sha256 = \"" + kNew + "\"  # and this\n[z]\ny = 2";
  EXPECT_EQ(with_golden_sha256(before, "f", kNew), after);
  EXPECT_EQ(with_golden_sha256(after, "f", kNew), after);
}

TEST(GoldenEdit, FindsEverySpellingOfTheKey) {
  EXPECT_EQ(with_golden_sha256("golden.sha256 = 'x'\n", "f", kNew), "golden.sha256 = \"" + kNew + "\"\n");
  EXPECT_EQ(with_golden_sha256("golden = { sha256 = \"\" }\n", "f", kNew), "golden = { sha256 = \"" + kNew + "\" }\n");
  EXPECT_EQ(with_golden_sha256("\"é\" = 1\ngolden = { \"sha256\" = '' } # é\n", "f", kNew),
            "\"é\" = 1\ngolden = { \"sha256\" = \"" + kNew + "\" } # é\n");
  EXPECT_EQ(with_golden_sha256("golden = { \"é\" = 1, sha256 = '' }\n", "f", kNew),
            "golden = { \"é\" = 1, sha256 = \"" + kNew + "\" }\n");
}

TEST(GoldenEdit, KeepsAByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(with_golden_sha256(mark + "golden.sha256 = 'x'\n", "f", kNew), mark + "golden.sha256 = \"" + kNew + "\"\n");
}

TEST(GoldenEdit, IgnoresTextThatOnlyLooksLikeTheTable) {
  const std::string text = "d = \"\"\"\n[golden]\nsha256 = \"no\"\n\"\"\"\n# [golden]\n";
  const std::string edited = with_golden_sha256(text, "f", kNew);
  EXPECT_TRUE(edited.starts_with(text));
  EXPECT_TRUE(edited.ends_with("[golden]\nsha256 = \"" + kNew + "\"\n"));
}

TEST(GoldenEdit, AddsTheTableAtTheEndAndTheKeyToATable) {
  EXPECT_THAT(with_golden_sha256("x = 1", "f", kNew), testing::EndsWith("[golden]\nsha256 = \"" + kNew + "\"\n"));
  EXPECT_THAT(with_golden_sha256("x = 1\r\n", "f", kNew),
              testing::EndsWith("[golden]\r\nsha256 = \"" + kNew + "\"\r\n"));
  EXPECT_EQ(with_golden_sha256("[golden] # c\n[z]\n", "f", kNew), "[golden] # c\nsha256 = \"" + kNew + "\"\n[z]\n");
}

TEST(GoldenEdit, RefusesWhatItCannotEditSafely) {
  EXPECT_THROW((void)with_golden_sha256("golden = { }\n", "f", kNew), InputError);
  EXPECT_THROW((void)with_golden_sha256("[golden]\nsha256 = \"\"\"x\"\"\"\n", "f", kNew), InputError);
  EXPECT_THROW((void)with_golden_sha256("golden = 3\n", "f", kNew), InputError);
}

struct Golden : testing::Test {
  Golden() { folder.write("s/scenario.toml", "description = \"d\" # why\nrobot = \"vo2021_6r\"\nduration_s = 1\n"); }

  [[nodiscard]] Scenario load() const {
    LoadOptions options;
    options.search_path = std::filesystem::path{ARMATURE_SOURCE_DIR} / "scenarios";
    return load_scenario(folder.path() / "s", options);
  }
  [[nodiscard]] std::filesystem::path trace(const std::string& value) const {
    return folder.write("out/trace.csv", "tick,j1_cmd_pulses\n0,0\n20," + value + "\n");
  }

  TempFolder folder;
};

TEST_F(Golden, IsTheTraceAndTheDigestInTheScenario) {
  EXPECT_THAT(bless_golden(load(), trace("5"), kOld), HasSubstr("s: new golden\n  golden.sha256: none -> aaaa"));
  EXPECT_EQ(read_file(folder.path() / "s/golden.csv"), "tick,j1_cmd_pulses\n0,0\n20,5\n");
  EXPECT_THAT(read_file(folder.path() / "s/scenario.toml"), HasSubstr("description = \"d\" # why\n"));
  EXPECT_EQ(load().golden.sha256, kOld);
}

TEST_F(Golden, BlessingAgainSaysWhatChanged) {
  (void)bless_golden(load(), trace("5"), kOld);
  EXPECT_EQ(bless_golden(load(), trace("5"), kOld), "s: golden unchanged\n");
  EXPECT_THAT(bless_golden(load(), trace("5"), kNew), HasSubstr("changed only between the rows"));
  EXPECT_THAT(bless_golden(load(), trace("8"), kNew), HasSubstr("j1_cmd_pulses: 3 at tick 20"));
  EXPECT_EQ(load().golden.sha256, kNew);
}

TEST_F(Golden, BlessingOneThatHasMoreRowsSaysSo) {
  (void)bless_golden(load(), trace("5"), kOld);
  folder.write("s/golden.csv", "tick,j1_cmd_pulses\n0,0\n10,3\n20,5\n");
  EXPECT_EQ(bless_golden(load(), trace("5"), kOld),
            "s: golden unchanged; golden.csv now has a row for every 200 ticks\n");
  EXPECT_EQ(read_file(folder.path() / "s/golden.csv"), "tick,j1_cmd_pulses\n0,0\n20,5\n");
}

TEST_F(Golden, BlessingNamesNoFileThatIsGoneAfterwards) {
  (void)bless_golden(load(), trace("5"), kOld);
  const std::string change = bless_golden(load(), trace("8"), kNew);
  EXPECT_THAT(change,
              HasSubstr("first mismatch at tick 20, j1_cmd_pulses: golden before 5, this run 8 (golden.csv line 3)"));
  EXPECT_THAT(change, testing::Not(HasSubstr("trace.csv")));
}

TEST(RunArgument, IsTheFolderOrTheFile) {
  Scenario scenario;
  scenario.file = "scenarios/x/scenario.toml";
  EXPECT_EQ(run_argument(scenario), "scenarios/x");
  EXPECT_EQ(golden_file(scenario), "scenarios/x/golden.csv");
  scenario.file = "scenario.toml";
  EXPECT_EQ(run_argument(scenario), ".");
  EXPECT_EQ(golden_file(scenario), "golden.csv");
  scenario.file = "a/nod.toml";
  EXPECT_EQ(run_argument(scenario), "a/nod.toml");
}

}  // namespace
}  // namespace armature::cosim
