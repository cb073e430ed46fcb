#include "cosim/page/serial_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "cosim/text/input_error.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using test::TempFolder;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::string with_header(const char* lines) {
  std::string text{"time_s,direction,byte,char,error,baud_error_percent,break_s\n"};
  return text.append(lines);
}

TEST(SerialRecord, CharactersThatFollowEachOtherAreOneText) {
  const TempFolder folder;
  const auto records = read_serial_record(
      folder.write("s.csv", with_header("0.100,rx,4F,O,,0,\n0.101,rx,4B,K,,0,\n0.102,tx,0A,\\n,,,\n0.500,tx,41,A,,,\n"
                                        "0.501,tx,42,B,framing,,\n")));
  ASSERT_EQ(records.size(), 4U);
  EXPECT_EQ(records[0].text, "OK");
  EXPECT_EQ(records[0].time_s, 0.1);
  EXPECT_EQ(records[1].text, "\\n");
  EXPECT_EQ(records[2].direction, "tx");
  EXPECT_EQ(records[3].error, "framing");
}

TEST(SerialRecord, ARunWithoutASerialLineHasNone) {
  EXPECT_TRUE(read_serial_record("/nowhere/serial.csv").empty());
}

TEST(SerialRecord, ALineWithAnotherNumberOfValuesIsAnErrorThatNamesIt) {
  const TempFolder folder;
  const auto file = folder.write("s.csv", with_header("0.1,rx\n"));
  EXPECT_THAT([&] { (void)read_serial_record(file); }, ThrowsMessage<InputError>(HasSubstr("s.csv:2: expected 7")));
}

}  // namespace
}  // namespace armature::cosim
