// TOML texts that are too large, too many or too deep, and those that only look so.
#include "cosim/scenario/toml/toml_limits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

#include "cosim/scenario/files/robot_loader.hpp"
#include "cosim/scenario/toml/toml_document.hpp"
#include "tests/cosim/support/scenario_files.hpp"

namespace armature::cosim {
namespace {

using test::error_of;
using test::scenario_with;
using test::shipped;
using test::TempFolder;
using testing::EndsWith;
using testing::HasSubstr;

std::string repeated(std::size_t count, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

std::string parse_error(const std::string& text) {
  try {
    (void)parse_toml(text, "f");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string scenario_error(const std::string& tables) {
  try {
    (void)scenario_with(tables);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TomlLimits, RefuseALargeFileUnread) {
  const TempFolder folder;
  const auto file = folder.write("s/scenario.toml", "");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 30U);  // without blocks on disk
  EXPECT_THAT(error_of(file), HasSubstr("NUL byte"));
  const auto text = folder.write("t/scenario.toml", std::string(kMaxTomlBytes + 1, '\n'));
  EXPECT_THAT(error_of(text), EndsWith("scenario.toml: is too large, expected at most 16 MiB"));
  EXPECT_EQ(parse_error(std::string(kMaxTomlBytes, '\n')), "");
}

TEST(TomlLimits, NameTheFirstTableThatIsTooMany) {
  const std::string move = "[[move]]\nat_s = 0.1\ntype = \"hold\"\n";
  EXPECT_EQ(scenario_with(repeated(10'000, move)).moves.size(), 10'000u);
  EXPECT_THAT(scenario_error(repeated(10'001, move)),
              EndsWith("scenario.toml:30004: expected at most 10000 tables [[move]]"));
  EXPECT_THAT(scenario_error(repeated(1'000'000, "[[ fault ]]\n")),
              EndsWith("scenario.toml:10004: expected at most 10000 tables [[fault]]"));
}

TEST(TomlLimits, HoldForTablesOnOneLine) {
  EXPECT_THAT(scenario_error("input = [" + repeated(10'001, "{},") + "]\n"),
              HasSubstr("input[10000]: expected at most 10000 tables [[input]], found 10001"));
}

TEST(TomlLimits, RefuseMoreValuesThanMemoryShouldHold) {
  EXPECT_EQ(parse_error("a = [" + repeated(400'000, "1,") + "]\n"), "");
  EXPECT_EQ(parse_error("\na = [" + repeated(500'000, "1,") + "]\n"),
            "f:2: expected at most 500000 values and parts of keys in a file");
}

TEST(TomlLimits, RefuseDepthThatWouldOverflowTheStack) {
  EXPECT_EQ(parse_error(repeated(15, "a.") + "a = 1\n"), "");
  EXPECT_THAT(parse_error("x = 1\n" + repeated(1'000'000, "a.") + "a = 1\n"),
              HasSubstr("f:2: expected keys of at most"));
  EXPECT_THAT(parse_error("[" + repeated(1'000'000, "'a' . \"b\" .") + "a]\n"), HasSubstr("expected keys of at most"));
  EXPECT_THAT(parse_error("a = " + repeated(1'000'000, "[")), HasSubstr("at most 32 nested arrays and tables"));
  EXPECT_THAT(parse_error("a = " + repeated(1'000'000, "{a=")), HasSubstr("at most 32 nested arrays and tables"));
}

TEST(TomlLimits, DoNotCountWhatStandsInStringsAndComments) {
  const std::string dots = repeated(100, "a.");
  const std::string brackets = repeated(100, "[");
  for (const std::string& text : {dots, brackets}) {
    EXPECT_EQ(parse_error("a = \"" + text + "\\\"" + text + "\"\n"), "");
    EXPECT_EQ(parse_error("a = '" + text + "'\n"), "");
    EXPECT_EQ(parse_error("a = \"\"\"\n" + text + "\n[[x]]\"\"" + text + "\\\"\"\"\"\n"), "");
    EXPECT_EQ(parse_error("a = '''" + text + "\n" + text + "'''\n"), "");
    EXPECT_EQ(parse_error("# " + text + "\n"), "");
  }
  // Up to two quotes before the closing three belong to the string; what follows is outside again.
  EXPECT_EQ(parse_error("a = [\"\"\"x\"\"\"\", \"" + dots + "\"]\n"), "");
  EXPECT_EQ(parse_error("a = ['''x''''', '" + dots + "']\n"), "");
  EXPECT_THAT(parse_error("a = \"\"\"x\"\"\"\"\n" + dots + "b = 1\n"), HasSubstr("f:2: expected keys"));
  EXPECT_THAT(parse_error("a = '''x'''''\n" + dots + "b = 1\n"), HasSubstr("f:2: expected keys"));
  EXPECT_THAT(parse_error("a = \"\\\\\"\n" + dots + "b = 1\n"), HasSubstr("f:2: expected keys"));
}

TEST(TomlLimits, HoldForOverrides) {
  LoadOptions options = shipped();
  options.overrides = {repeated(30'000, "a.") + "a=1"};
  EXPECT_THAT(error_of("fig9_joint_move", options), HasSubstr("expected key=value with a dotted key"));
  options.overrides = {"seed=" + std::string(60'000, '[')};
  EXPECT_THAT(error_of("fig9_joint_move", options), HasSubstr("seed: expected an integer"));
}

TEST(TomlText, MayBeginWithAByteOrderMark) {
  const ConfigValue document = parse_toml("\xEF\xBB\xBFkey = 1\n", "f");
  ASSERT_NE(document.find("key"), nullptr);
  EXPECT_EQ(document.find("key")->origin.column, 1);
}

TEST(TomlText, IsReadFromRegularFilesOnly) {
  const TempFolder folder;
  const auto pipe = folder.path() / "robot.toml";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW((void)read_toml(pipe), InputError);
  EXPECT_THROW((void)load_robot(pipe), InputError);
  EXPECT_NE(error_of(pipe), "");
  EXPECT_NE(error_of("/dev/zero"), "");
}

TEST(TomlText, MayHaveManyMistakesOrALongOne) {
  EXPECT_THAT(scenario_error(std::string(1'000'000, 'x') + " = 1\n"), HasSubstr("xxx[...]: unknown key; known: "));
  const std::string error = scenario_error(repeated(2'000, "[[move]]\nat = 1\n"));
  EXPECT_TRUE(error.ends_with("more problems")) << error.substr(error.size() - 100);
  EXPECT_LT(error.size(), 100'000u);
}

}  // namespace
}  // namespace armature::cosim
