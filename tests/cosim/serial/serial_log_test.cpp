#include "cosim/serial/serial_log.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/serial/serial_line.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/text_file.hpp"
#include "tests/cosim/support/temp_folder.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

using test::TempFolder;
using testing::HasSubstr;

SerialEvent rx(std::int64_t cycle, char byte) {
  SerialEvent event;
  event.at = Cycles{cycle};
  event.byte = static_cast<std::uint8_t>(byte);
  return event;
}

TEST(SerialLog, ARowHasTheExactTimeTheByteAndItsError) {
  EXPECT_EQ(serial_log_row(rx(500'000, 'A')), "0.01000000,rx,41,A,,0.0000,");
  SerialEvent event = rx(61'728'394'512'345, '\r');
  event.direction = SerialDirection::kTx;
  event.parity_error = event.framing_error = true;
  EXPECT_EQ(serial_log_row(event), "1234567.89024690,tx,0D,\\r,parity framing,,");
  SerialEvent slow = rx(1, 'x');
  slow.baud_error_ppm = -15'005;
  slow.framing_error = true;
  EXPECT_EQ(serial_log_row(slow), "0.00000002,rx,78,x,framing,-1.5005,");
  SerialEvent pause = rx(2, '\0');
  pause.is_break = true;
  pause.break_duration = Cycles{50'001};
  EXPECT_EQ(serial_log_row(pause), "0.00000004,rx,00,\\x00,break,0.0000,0.00100002");
}

TEST(SerialLog, EveryByteStaysOneField) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::string row = serial_log_row(rx(0, static_cast<char>(byte)));
    EXPECT_EQ(std::ranges::count(row, ','), 6) << row;
    EXPECT_EQ(row.find_first_of("\"\r\n"), std::string::npos) << row;
  }
}

// A line wired to itself, with everything that a scenario can send.
std::vector<SerialEvent> run(const std::vector<SerialSendSpec>& sends) {
  const SerialFormat format{.baud = 115'200, .parity = SerialParity::kOdd};
  std::vector<SerialEvent> events;
  SerialLine line{format, to_script(sends), [&](const SerialEvent& event) { events.push_back(event); }};
  while (const auto next = line.next_event()) {
    line.advance(*next);
    line.on_level(*next, line.rxd());
  }
  return events;
}

std::string write(const std::filesystem::path& file, const std::vector<SerialEvent>& events) {
  SerialLog log{file};
  for (const SerialEvent& event : events) log.write(event);
  log.close();
  return read_text_file(file);
}

TEST(SerialLog, AReplayOfItsRowsIsTheSameCycleByCycle) {
  constexpr std::uint64_t kSeed = 7;
  armature::test::SplitMix random{kSeed};
  std::vector<SerialSendSpec> sends;
  for (int i = 0; i < 200; ++i) {
    SerialSendSpec send;
    send.at_s = random.below(3'000) * 1e-5;
    send.fault = static_cast<SerialFault>(random.below(4));
    if (send.fault == SerialFault::kBreak) {
      send.break_s = 1e-4 + random.below(1'000) * 1e-7;
    } else {
      for (std::uint32_t n = random.below(4); n > 0; --n) send.bytes += static_cast<char>(random.next());
      send.baud_error_percent = (random.below(60'000) - 30'000.0) * 1e-4;
    }
    sends.push_back(send);
  }
  const TempFolder folder;
  const std::string first = write(folder.path() / "serial.csv", run(sends));
  const std::string again =
      write(folder.path() / "again.csv", run(parse_serial_log("serial.csv", first, {.parity = "odd"})));
  EXPECT_GT(std::ranges::count(first, '\n'), 400) << "seed " << kSeed;
  EXPECT_EQ(first, again) << "seed " << kSeed;
}

TEST(SerialLog, AFileThatCannotBeWrittenIsTold) {
  EXPECT_THROW(SerialLog{"/no/such/folder/serial.csv"}, InputError);
  SerialLog full{"/dev/full"};
  full.write(rx(0, 'a'));
  EXPECT_THROW(full.close(), InputError);
}

TEST(SerialLog, AReplayTakesWhatASpreadsheetSaved) {
  const auto sends = parse_serial_log(
      "serial.csv", fmt::format("\xEF\xBB\xBF{}\r\n1,rx,41,A,,0.0000,\r\n2,rx,42,B,,0.0000,", kSerialLogHeader), {});
  ASSERT_EQ(sends.size(), 2u);
  EXPECT_EQ(sends[1].bytes, "B");
}

TEST(SerialLog, WhatIsNoLogIsRefusedWithItsPlace) {
  const auto log = [](std::string_view rows) { return fmt::format("{}\n{}", kSerialLogHeader, rows); };
  const std::pair<std::string, std::string> cases[] = {
      {"", "is empty"},
      {"tick,cycle\n", ":1:1: expected the header"},
      {log("0.5,rx,41,A,,0.0000,\n0.6,up,41,A,,0.0000,\n"), ":3:5: expected \"rx\" or \"tx\", found \"up\""},
      {log("soon,rx,41,A,,0.0000,\n"), ":2:1: expected time_s = 0..86400"},
      {log("-1,rx,41,A,,0.0000,\n"), ":2:1: expected time_s = 0..86400"},
      {log("nan,rx,41,A,,0.0000,\n"), ":2:1: expected time_s = 0..86400"},
      {log("1,rx,4,A,,0.0000,\n"), ":2:6: expected two hexadecimal digits, found \"4\""},
      {log("1,rx,4G,A,,0.0000,\n"), ":2:6: expected two hexadecimal digits"},
      {log("1,rx,41,A,late,0.0000,\n"), ":2:11: expected nothing, \"framing\""},
      {log("1,rx,41,A,,,\n"), ":2:12: expected baud_error_percent = -50..50"},
      {log("1,rx,41,A,,99,\n"), ":2:12: expected baud_error_percent = -50..50"},
      {log("1,rx,00,,break,0,\n"), ":2:18: expected break_s = 0..86400"},
      {log("1,rx,41,A\n"), ":2:1: expected 7 values"},
      {log("1,rx,41,A,,0.0000,0.1\n"), ":2:19: expected break_s of a break only"},
      {log("1,rx,C1,A,,0.0000,\n"), ":2:6: expected a byte of serial.data_bits = 7, found \"C1\""},
      {log("1,rx,41,A,parity,0.0000,\n"), ":2:11: expected no wrong parity"},
      {log("1,rx,41,A,,0.0000,\n0.5,rx,41,A,,0.0000,\n"), ":3:1: expected a time not before the last one"},
  };
  for (const auto& [text, message] : cases) {
    SCOPED_TRACE(text);
    try {
      (void)parse_serial_log("serial.csv", text, {.data_bits = 7});
      ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(message));
    }
  }
}

}  // namespace
}  // namespace armature::cosim
