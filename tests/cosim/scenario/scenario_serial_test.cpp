// [serial], [[serial_send]] and what [expect] says of the serial line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/serial/serial_line.hpp"
#include "cosim/text/byte_text.hpp"
#include "tests/cosim/support/expect_failures.hpp"
#include "tests/cosim/support/scenario_files.hpp"

namespace armature::cosim {
namespace {

using test::scenario_with;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(ScenarioSerial, WithoutTheTableNothingIsConnected) {
  const Scenario scenario = scenario_with("");
  EXPECT_FALSE(scenario.serial);
  EXPECT_TRUE(scenario.serial_sends.empty());
  EXPECT_FALSE(scenario.expect.serial_sent);
}

TEST(ScenarioSerial, AnEmptyTableIsALineOf115200BaudEightBitsNoParityOneStop) {
  const SerialFormat format = SerialFormat::from(*scenario_with("[serial]\n").serial);
  EXPECT_EQ(format.baud, 115'200);
  EXPECT_EQ(format.data_bits, 8);
  EXPECT_EQ(format.parity, SerialParity::kNone);
  EXPECT_EQ(format.stop_half_bits, 2);
}

TEST(ScenarioSerial, ReadsEveryKey) {
  const Scenario scenario = scenario_with(R"(
[serial]
baud = 9600
data_bits = 7
parity = "mark"
stop_bits = 1.5
[[serial_send]]
at_s = 0.5
hex = "0d0A 7F"
baud_error_percent = -2.5
fault = "framing"
[[serial_send]]
at_s = 0.25
text = "M1\r"
fault = "parity"
[[serial_send]]
at_s = 0.75
fault = "break"
break_s = 0.002
[expect]
serial_hex = "6f 6B"
)");
  const SerialFormat format = SerialFormat::from(*scenario.serial);
  EXPECT_EQ(format.baud, 9'600);
  EXPECT_EQ(format.data_bits, 7);
  EXPECT_EQ(format.parity, SerialParity::kMark);
  EXPECT_EQ(format.stop_half_bits, 3);
  EXPECT_EQ(scenario.expect.serial_sent, "ok");
  EXPECT_TRUE(scenario.expect.serial_as_hex);

  const std::vector<ScriptedItem> script = to_script(scenario.serial_sends);
  ASSERT_EQ(script.size(), 7u);
  EXPECT_EQ(script[0].at, Cycles{12'500'000});
  EXPECT_EQ(script[0].item.data, 'M');
  EXPECT_TRUE(script[0].item.wrong_parity);
  EXPECT_EQ(script[2].item.data, '\r');
  EXPECT_EQ(script[3].item.data, 0x0D);
  EXPECT_EQ(script[5].item.data, 0x7F);
  EXPECT_EQ(script[5].item.baud_error_ppm, -25'000);
  EXPECT_TRUE(script[5].item.no_stop);
  EXPECT_EQ(script[6].item.kind, LineItem::Kind::kBreak);
  EXPECT_EQ(script[6].item.duration, Cycles{100'000});
}

TEST(ScenarioSerial, ATextIsItsBytes) {
  EXPECT_EQ(scenario_with("[serial]\n[[serial_send]]\nat_s = 0\ntext = \"\u00e9\"\n").serial_sends[0].bytes,
            "\xC3\xA9");
}

std::vector<std::string> failures(const std::string& expect_table, const std::string& sent, std::int64_t errors) {
  RunFacts facts;
  facts.serial_sent = sent;
  facts.serial_errors = errors;
  return test::failures(scenario_with("[serial]\n[expect]\n" + expect_table).expect, facts);
}

TEST(ScenarioSerial, ExpectsExactlyTheBytesThatTheControllerSent) {
  EXPECT_THAT(failures("serial_text = \"ok\\n\"", "ok\n", 0), IsEmpty());
  EXPECT_THAT(failures("serial_hex = \"00 fF\"", std::string("\0\xFF", 2), 0), IsEmpty());
  EXPECT_THAT(failures("serial_text = \"\"", "", 0), IsEmpty());
  EXPECT_THAT(failures("serial_text = \"ok\\n\"", "ok\r\n", 0),
              ElementsAre("expect.serial_text: expected \"ok\\n\", got \"ok\\r\\n\""));
  EXPECT_THAT(failures("serial_hex = \"41\"", "AB", 0),
              ElementsAre("expect.serial_hex: expected \"41\", got \"41 42\""));
  EXPECT_THAT(failures("serial_text = \"ok\"", "ok", 2),
              ElementsAre("expect.serial_text: expected \"ok\", got \"ok\" with 2 errors or breaks"));
  EXPECT_THAT(failures("serial_text = \"\"", "x", 0), ElementsAre("expect.serial_text: expected \"\", got \"x\""));
  EXPECT_THAT(failures("underruns = 0", "x", 2), IsEmpty()) << "not asked for";
}

TEST(ByteText, HexIsReadInAnyGrouping) {
  EXPECT_EQ(bytes_of_hex(" 48  69 0d0A "), "Hi\r\n");
  EXPECT_EQ(bytes_of_hex(""), "");
  for (const char* bad : {"4", "414", "4 1", "0x41", "4g", "41,42"}) EXPECT_EQ(bytes_of_hex(bad), std::nullopt) << bad;
}

TEST(ByteText, QuotesStayOnOneLine) {
  EXPECT_EQ(quoted_bytes(std::string("a\"\\\r\n\t\0\xFF", 8)), "\"a\\\"\\\\\\r\\n\\t\\x00\\xFF\"");
  EXPECT_EQ(hex_of_bytes(std::string("a\xFF", 2)), "61 FF");
}

}  // namespace
}  // namespace armature::cosim
