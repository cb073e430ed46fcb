// Trace files as other programs write them, and what is no trace file.
#include "cosim/trace/csv_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cosim/text/input_error.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using namespace std::string_literals;
using test::TempFolder;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

std::vector<std::int64_t> ticks_of(const std::string& text) {
  const TempFolder folder;
  CsvReader reader{folder.write("a.csv", text)};
  std::vector<std::int64_t> ticks;
  while (reader.next()) ticks.push_back(reader.row().tick());
  return ticks;
}

std::string error_of(const std::filesystem::path& file) {
  try {
    CsvReader reader{file};
    while (reader.next()) {
    }
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string error_of_text(const std::string& text) {
  const TempFolder folder;
  return error_of(folder.write("a.csv", text));
}

TEST(CsvReader, TakesAByteOrderMarkCrLfAndAMissingEndOfTheLastLine) {
  EXPECT_THAT(ticks_of("tick,a\n1,2\n2,3\n"), ElementsAre(1, 2));
  EXPECT_THAT(ticks_of("\xEF\xBB\xBFtick,a\n1,2\n"), ElementsAre(1));
  EXPECT_THAT(ticks_of("tick,a\r\n1,2\r\n2,3\r\n"), ElementsAre(1, 2));
  EXPECT_THAT(ticks_of("tick,a\n1,2\n2,3"), ElementsAre(1, 2));
  EXPECT_THAT(ticks_of("tick"), ElementsAre());
}

TEST(CsvReader, CountsColumnsBehindAByteOrderMarkFromOne) {
  EXPECT_THAT(error_of_text("\xEF\xBB\xBFtack,a\n"), HasSubstr("a.csv:1:1: "));
}

TEST(CsvReader, NamesAnotherEncoding) {
  EXPECT_THAT(error_of_text("\xFF\xFEt\0i\0c\0k\0\n\0"s), EndsWith("a.csv: is UTF-16 text, expected UTF-8"));
}

TEST(CsvReader, RefusesALineWithoutEnd) {
  const std::string longest(CsvReader::kLongestLine - 8, 'x');
  EXPECT_EQ(error_of_text("tick," + longest + "\n1,2\n"), "");
  EXPECT_THAT(error_of_text("tick,a\n1," + longest + "xxxxxx\n"), HasSubstr("a.csv:2: expected lines of less than"));
  EXPECT_THAT(error_of("/dev/zero"), HasSubstr("/dev/zero:1: expected lines of less than 65536 bytes"));
}

TEST(CsvReader, ShowsWhatItFoundOnOnePrintableLine) {
  EXPECT_THAT(error_of_text("\x1b[2Jtick,a\n"), EndsWith("expected the column \"tick\", found another text"));
  EXPECT_THAT(error_of_text("tick,a\n" + std::string(5'000, '1') + "x,0\n"), HasSubstr("111[...]\""));
}

}  // namespace
}  // namespace armature::cosim
