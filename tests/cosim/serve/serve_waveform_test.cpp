#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "cosim/text/input_error.hpp"
#include "tests/cosim/support/serve_session.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;
using test::ServeSession;
using testing::AllOf;
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
  ServeSession session{folder.path()};
  session("run 100");
  EXPECT_EQ(session("vcd a b.vcd  "), "ok") << "blanks within the name belong to it";
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
  ServeSession session{folder.path()};
  EXPECT_EQ(session("vcd 1.vcd"), "ok");
  session("run 10");
  EXPECT_EQ(session("vcd 2.vcd"), "ok");
  session("run 10");
  session("vcd");
  EXPECT_EQ(times_of(test::read_file(first)).back(), 10 * 20 + 10);
  const std::string text = test::read_file(second);
  EXPECT_THAT(text, HasSubstr("$enddefinitions"));
  EXPECT_EQ(times_of(text).front(), 11 * 20);
  EXPECT_EQ(times_of(text).back(), 20 * 20 + 10);
}

TEST(ServeWaveform, IsRefusedWithoutAFolderForIt) {
  ServeSession session;
  EXPECT_THAT(session("vcd a.vcd"), AllOf(StartsWith("error "), HasSubstr("--out DIR")));
  EXPECT_FALSE(fs::exists("a.vcd"));
  EXPECT_EQ(session("vcd"), "ok");
}

TEST(ServeWaveform, MayBeInAFolderBelow) {
  const test::TempFolder folder;
  fs::create_directories(folder.path() / "a" / "b");
  ServeSession session{folder.path()};
  EXPECT_EQ(session("vcd ./a//b/c.vcd"), "ok");
  session("run 10");
  session("vcd");
  EXPECT_EQ(times_of(test::read_file(folder.path() / "a" / "b" / "c.vcd")).back(), 10 * 20 + 10);
}

TEST(ServeWaveform, TheFolderIsMadeOrTheReasonSaid) {
  const test::TempFolder folder;
  { const WaveFolder made{folder.path() / "a" / "b"}; }
  EXPECT_TRUE(fs::is_directory(folder.path() / "a" / "b"));
  const fs::path file = folder.write("file", "keep");
  for (const fs::path& wrong : {file, file / "below", fs::path{}}) {
    EXPECT_THAT([&] { WaveFolder{wrong}; },
                testing::ThrowsMessage<InputError>(
                    AllOf(StartsWith("--out " + wrong.string() + ": "), HasSubstr("cannot use the folder"))))
        << wrong;
  }
}

// What a client must not reach lies in `outside`, beside the folder of --out.
struct Fence {
  Fence() { fs::create_directories(out); }

  test::TempFolder folder;
  fs::path out = folder.path() / "out";
  fs::path precious = folder.write("outside/precious.vcd", "keep");
};

TEST(ServeWaveform, NoNameLeadsOutOfTheFolder) {
  const Fence fence;
  fs::create_directory(fence.out / "below");
  fs::create_directory_symlink("../outside", fence.out / "link");
  fs::create_directory_symlink(fence.precious.parent_path(), fence.out / "absolute");
  ServeSession session{fence.out};
  const std::pair<std::string, const char*> cases[] = {
      {fence.precious.string(), "not an absolute path"},
      {(fence.precious.parent_path() / "new.vcd").string(), "not an absolute path"},
      {"../outside/precious.vcd", "without '..'"},
      {"../new.vcd", "without '..'"},
      {"below/../../outside/precious.vcd", "without '..'"},
      {"below/../new.vcd", "without '..'"},
      {"link/precious.vcd", "cannot write"},
      {"link/new.vcd", "cannot write"},
      {"absolute/precious.vcd", "cannot write"},
      {"no/new.vcd", "cannot write"},
  };
  for (const auto& [name, why] : cases) {
    EXPECT_THAT(session("vcd " + name), AllOf(StartsWith("error "), HasSubstr(why))) << name;
  }
  session("run 10");
  EXPECT_EQ(test::read_file(fence.precious), "keep");
  EXPECT_FALSE(fs::exists(fence.precious.parent_path() / "new.vcd"));
  EXPECT_FALSE(fs::exists(fence.out / "new.vcd"));
}

TEST(ServeWaveform, NothingButPlainFilesThatAreNamedAsWaveformsAreWritten) {
  const Fence fence;
  fence.folder.write("out/text.txt", "keep");
  const auto at = [&](const char* name) { return (fence.out / name).string(); };
  fs::create_symlink(fence.precious, at("link.vcd"));
  fs::create_symlink("text.txt", at("near.vcd"));
  fs::create_symlink(fence.precious.parent_path() / "new.vcd", at("dangling.vcd"));
  fs::create_hard_link(fence.precious, at("second.vcd"));
  ASSERT_EQ(mkfifo(at("pipe.vcd").c_str(), 0600), 0);
  fs::create_directory(at("dir.vcd"));
  ServeSession session{fence.out};
  for (const char* name : {"text.txt", ".vcd", "a.VCD"}) {
    EXPECT_THAT(session(std::string{"vcd "} + name), StartsWith("error FILE must end in .vcd")) << name;
  }
  EXPECT_THAT(session("vcd text.txt" + std::string{'\0'} + ".vcd"), StartsWith("error FILE must end in .vcd"));
  for (const char* name : {"link.vcd", "near.vcd", "dangling.vcd", "pipe.vcd", "dir.vcd"}) {
    EXPECT_THAT(session(std::string{"vcd "} + name), AllOf(StartsWith("error "), HasSubstr("no plain file"))) << name;
  }
  EXPECT_THAT(session("vcd second.vcd"), AllOf(StartsWith("error "), HasSubstr("hard link")));
  session("run 10");
  EXPECT_EQ(test::read_file(fence.precious), "keep");
  EXPECT_EQ(test::read_file(at("text.txt")), "keep");
  EXPECT_FALSE(fs::exists(fence.precious.parent_path() / "new.vcd"));
}

TEST(ServeWaveform, StaysInTheFolderThatWasGivenWhenItsNameIsTakenByAnother) {
  const Fence fence;
  ServeSession session{fence.out};
  fs::rename(fence.out, fence.folder.path() / "moved");
  fs::create_directory_symlink("outside", fence.out);
  EXPECT_EQ(session("vcd precious.vcd"), "ok");
  session("run 10");
  session("vcd");
  EXPECT_EQ(test::read_file(fence.precious), "keep");
  EXPECT_EQ(times_of(test::read_file(fence.folder.path() / "moved" / "precious.vcd")).back(), 10 * 20 + 10);
}

TEST(ServeWaveform, ARefusedNameLeavesTheFileBeforeOpen) {
  const test::TempFolder folder;
  const std::string file = folder.path() / "a.vcd";
  ServeSession session{folder.path()};
  session("vcd a.vcd");
  session("run 10");
  EXPECT_THAT(session("vcd a.txt"), StartsWith("error "));
  EXPECT_THAT(session("vcd no/b.vcd"), StartsWith("error cannot write "));
  session("run 10");
  session("vcd");
  EXPECT_EQ(times_of(test::read_file(file)).back(), 20 * 20 + 10);
}

TEST(ServeWaveform, IsCompleteWhenTheServerEnds) {
  const test::TempFolder folder;
  const std::string file = folder.path() / "a.vcd";
  {
    ServeSession session{folder.path()};
    session("vcd a.vcd");
    session("run 1000");
  }
  EXPECT_EQ(times_of(test::read_file(file)).back(), 1000 * 20 + 10);
}

}  // namespace
}  // namespace armature::cosim
