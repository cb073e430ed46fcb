// Files of text: what is read and refused, what is left when they are replaced.
#include "cosim/text/text_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "cosim/text/input_error.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;
using test::read_file;
using test::TempFolder;
using testing::EndsWith;
using testing::HasSubstr;

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ReadTextFile, GivesAllBytesUpToTheLimit) {
  const TempFolder folder;
  const std::string text(200'000, 'x');
  const fs::path file = folder.write("a", text);
  EXPECT_EQ(read_text_file(file), text);
  EXPECT_EQ(read_text_file(file, 200'000), text);
  EXPECT_THAT(error_of([&] { (void)read_text_file(file, 199'999); }), HasSubstr("is too large"));
  EXPECT_EQ(read_text_file(folder.write("empty", "")), "");
}

TEST(ReadTextFile, NamesAnotherEncoding) {
  const TempFolder folder;
  EXPECT_THAT(error_of([&] { (void)read_text_file(folder.write("le", "\xff\xfet\0o\0"s)); }),
              EndsWith("le: is UTF-16 text, expected UTF-8"));
  EXPECT_THAT(error_of([&] { (void)read_text_file(folder.write("be", "\xfe\xff\0t"s)); }),
              EndsWith("be: is UTF-16 text, expected UTF-8"));
  EXPECT_THAT(error_of([&] { (void)read_text_file(folder.write("32", "\xff\xfe\0\0t\0\0\0"s)); }),
              EndsWith("32: is UTF-32 text, expected UTF-8"));
  EXPECT_THAT(error_of([&] { (void)read_text_file(folder.write("none", "a\nb\0"s)); }),
              EndsWith("none:2: holds a NUL byte, expected UTF-8 text"));
}

TEST(ReadTextFile, DoesNotFillTheMemoryFromADeviceWithoutEnd) {
  EXPECT_THAT(error_of([] { (void)read_text_file("/dev/zero"); }), HasSubstr("NUL byte"));
}

TEST(RequireRegularFile, NamesWhatIsThere) {
  const TempFolder folder;
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(error_of([&] { require_regular_file(pipe); }), EndsWith("pipe: is a pipe, expected a file"));
  EXPECT_THAT(error_of([&] { require_regular_file(folder.path()); }), EndsWith("is a folder, expected a file"));
  EXPECT_THAT(error_of([&] { require_regular_file("/dev/zero"); }), EndsWith("is a device, expected a file"));
  const fs::path link = folder.path() / "link";
  fs::create_symlink(folder.write("file", "x"), link);
  EXPECT_EQ(error_of([&] { require_regular_file(link); }), "");
  EXPECT_EQ(error_of([&] { require_regular_file(folder.path() / "none"); }), "");
}

TEST(ReplaceTextFile, LeavesNothingBesideAndTouchesNothingElse) {
  const TempFolder folder;
  const fs::path file = folder.write("a", "old");
  const fs::path other = folder.write("a.new", "somebody else's");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  replace_text_file(file, "fresh");
  EXPECT_EQ(read_file(file), "fresh");
  EXPECT_EQ(read_file(other), "somebody else's");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(std::distance(fs::directory_iterator{folder.path()}, {}), 2);
}

TEST(ReplaceTextFile, WritesWhereALinkLeads) {
  const TempFolder folder;
  const fs::path file = folder.write("a", "old");
  fs::create_symlink(file, folder.path() / "link");
  replace_text_file(folder.path() / "link", "fresh");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
  EXPECT_EQ(read_file(file), "fresh");
}

}  // namespace
}  // namespace armature::cosim
