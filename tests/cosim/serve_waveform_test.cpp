#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "tests/cosim/serve_session.hpp"
#include "tests/cosim/temp_folder.hpp"

namespace armature::cosim {
namespace {

using test::ServeSession;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::int64_t> times_of(const std::string& vcd) {
  std::vector<std::int64_t> times;
  const std::regex time{"\n#([0-9]+)"};
  for (std::sregex_iterator it{vcd.begin(), vcd.end(), time}, end; it != end; ++it)
    times.push_back(std::stoll((*it)[1]));
  return times;
}

TEST(ServeWaveform, HoldsTheClocksBetweenOpeningAndClosing) {
  const test::TempFolder folder;
  const std::string file = folder.path() / "a b.vcd";
  ServeSession session;
  session("run 100");
  EXPECT_EQ(session("vcd " + file + "  "), "ok") << "blanks within the name belong to it";
  session("run 50");
  EXPECT_EQ(session("vcd"), "ok");
  session("run 100");
  const std::string text = test::read_file(file);
  for (const char* name : {"clk_i", "step_o", "s_axi_awaddr_i", "uart_rxd_i"}) EXPECT_THAT(text, HasSubstr(name));
  const auto times = times_of(text);
  ASSERT_FALSE(times.empty());
  EXPECT_EQ(times.front(), 101 * 20);
  EXPECT_EQ(times.back(), 150 * 20 + 10);
}

TEST(ServeWaveform, ASecondFileEndsTheFirst) {
  const test::TempFolder folder;
  const std::string first = folder.path() / "1.vcd", second = folder.path() / "2.vcd";
  ServeSession session;
  EXPECT_EQ(session("vcd " + first), "ok");
  session("run 10");
  EXPECT_EQ(session("vcd " + second), "ok");
  session("run 10");
  session("vcd");
  EXPECT_EQ(times_of(test::read_file(first)).back(), 10 * 20 + 10);
  const std::string text = test::read_file(second);
  EXPECT_THAT(text, HasSubstr("$enddefinitions"));
  EXPECT_EQ(times_of(text).front(), 11 * 20);
  EXPECT_EQ(times_of(text).back(), 20 * 20 + 10);
}

TEST(ServeWaveform, NothingButPlainFilesThatAreNamedAsWaveformsAreWritten) {
  const test::TempFolder folder;
  const std::string text = folder.write("precious.txt", "keep");
  const std::string pipe = folder.path() / "pipe.vcd", dir = folder.path() / "dir.vcd";
  const std::string link = folder.path() / "link.vcd";
  std::filesystem::create_symlink(text, link);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_directory(dir);
  ServeSession session;
  EXPECT_THAT(session("vcd " + text), StartsWith("error FILE must end in .vcd"));
  EXPECT_THAT(session("vcd " + text + std::string{'\0'} + ".vcd"), StartsWith("error FILE must end in .vcd"));
  EXPECT_THAT(session("vcd .vcd"), StartsWith("error FILE must end in .vcd"));
  EXPECT_THAT(session("vcd " + pipe), StartsWith("error "));
  EXPECT_THAT(session("vcd " + pipe), HasSubstr("no plain file"));
  EXPECT_THAT(session("vcd " + dir), HasSubstr("no plain file"));
  EXPECT_THAT(session("vcd " + link), HasSubstr("no plain file"));
  EXPECT_THAT(session("vcd " + (folder.path() / "no" / "a.vcd").string()), StartsWith("error cannot write "));
  EXPECT_EQ(test::read_file(text), "keep");
}

TEST(ServeWaveform, ARefusedNameLeavesTheFileBeforeOpen) {
  const test::TempFolder folder;
  const std::string file = folder.path() / "a.vcd";
  ServeSession session;
  session("vcd " + file);
  session("run 10");
  EXPECT_THAT(session("vcd a.txt"), StartsWith("error "));
  EXPECT_THAT(session("vcd " + (folder.path() / "no" / "b.vcd").string()), StartsWith("error cannot write "));
  session("run 10");
  session("vcd");
  EXPECT_EQ(times_of(test::read_file(file)).back(), 20 * 20 + 10);
}

TEST(ServeWaveform, IsCompleteWhenTheServerEnds) {
  const test::TempFolder folder;
  const std::string file = folder.path() / "a.vcd";
  {
    ServeSession session;
    session("vcd " + file);
    session("run 1000");
  }
  EXPECT_EQ(times_of(test::read_file(file)).back(), 1000 * 20 + 10);
}

}  // namespace
}  // namespace armature::cosim
