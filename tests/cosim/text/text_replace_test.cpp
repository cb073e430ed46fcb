// Files of text: how they are replaced, and whether they can be.
#include "cosim/text/text_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <stdexcept>

#include "cosim/text/input_error.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using testing::EndsWith;

TEST(TextFile, IsReplacedAsAWholeAndThroughALink) {
  const test::TempFolder folder;
  const auto file = folder.write("a/file.txt", "old and longer");
  replace_text_file(file, "new");
  EXPECT_EQ(test::read_file(file), "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator{folder.path() / "a"}, {}), 1);
  std::filesystem::create_symlink("a/file.txt", folder.path() / "link");
  replace_text_file(folder.path() / "link", "through");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link"));
  EXPECT_EQ(test::read_file(file), "through");
}

TEST(TextFile, AFullDiskIsAnErrorThatNamesTheFile) {
  const test::TempFolder folder;
  std::filesystem::create_symlink("/dev/full", folder.path() / "full");
  try {
    replace_text_file(folder.path() / "full", "text");
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), EndsWith("/full: cannot write: No space left on device"));
  }
}

TEST(TextFile, BeingWritableIsKnownWithoutTouchingIt) {
  const test::TempFolder folder;
  const auto file = folder.write("file.txt", "kept");
  require_writable(file);
  EXPECT_EQ(test::read_file(file), "kept");
  require_writable(folder.path() / "fresh.txt");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "fresh.txt"));
  EXPECT_THROW(require_writable(folder.path()), InputError);
  EXPECT_THROW(require_writable(folder.path() / "missing/file.txt"), InputError);
  EXPECT_THROW(require_writable(file / "below_a_file.txt"), InputError);
}

}  // namespace
}  // namespace armature::cosim
