#include "cosim/pendant/message_reader.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <string>

namespace armature::cosim {
namespace {

using pendant::MessageKind;

// The pages of a message, as PROTOCOL.md describes them.
struct Pages {
  int number = 0;
  MessageKind kind = MessageKind::kNone;
  std::int32_t place = 0;
  std::string text;

  [[nodiscard]] std::int32_t header() const {
    return number + 65'536 * static_cast<int>(kind) + 262'144 * static_cast<int>(text.size());
  }
  [[nodiscard]] std::int32_t at(std::uint8_t page) const {
    if (page == 16) return header();
    if (page == 17) return place;
    std::int32_t value = 0;
    for (std::size_t i = 3; i-- > 0;) {
      const std::size_t character = 3 * (page - 18U) + i;
      value = 256 * value + (character < text.size() ? static_cast<unsigned char>(text[character]) : 0);
    }
    return value;
  }
};

// The number of pages that were read until there is nothing to do.
int read_all(MessageReader& reader, const Pages& pages) {
  int read = 0;
  for (; reader.next() && read < 100; ++read) reader.on_page(pages.at(*reader.next()));
  return read;
}

TEST(MessageReader, ReadsNothingBeforeThereIsAMessage) {
  MessageReader reader;
  EXPECT_EQ(reader.next(), std::nullopt);
  reader.on_telemetry(0);
  EXPECT_EQ(reader.next(), std::nullopt);
  EXPECT_FALSE(reader.message());
}

TEST(MessageReader, ReadsEachLengthOfAText) {
  for (std::size_t size = 0; size <= 64; ++size) {
    MessageReader reader;
    const Pages pages{5, MessageKind::kMessage, 12, std::string(size, 'x')};
    reader.begin();
    EXPECT_EQ(read_all(reader, pages), 3 + (static_cast<int>(size) + 2) / 3) << size;
    ASSERT_TRUE(reader.message());
    EXPECT_EQ(reader.message()->text, pages.text);
    EXPECT_EQ(reader.message()->place, 12);
    EXPECT_EQ(reader.message()->header.number, 5);
  }
}

TEST(MessageReader, ReadsAMessageOfTheTelemetryOnce) {
  MessageReader reader;
  const Pages pages{1, MessageKind::kMessage, 7, "hello"};
  reader.on_telemetry(pages.header());
  EXPECT_GT(read_all(reader, pages), 0);
  EXPECT_EQ(message_text(*reader.message()), "message: \"hello\"");
  reader.on_telemetry(pages.header());
  EXPECT_EQ(reader.next(), std::nullopt);
  EXPECT_EQ(reader.read(), 1);
}

TEST(MessageReader, NeverMixesTwoMessages) {
  const Pages first{1, MessageKind::kMessage, 7, "aaaaaaaaaaaa"}, second{2, MessageKind::kAlarm, 9, "bbbbbbbbbbbbbbb"};
  for (int until = 1; until <= 7; ++until) {  // the second message comes behind this page
    MessageReader reader;
    reader.begin();
    for (int i = 0; i < until; ++i) {
      ASSERT_TRUE(reader.next());
      reader.on_page(first.at(*reader.next()));
    }
    const bool complete = !reader.next();
    EXPECT_EQ(complete, until == 7);
    if (complete) continue;
    static_cast<void>(read_all(reader, second));
    ASSERT_TRUE(reader.message());
    EXPECT_EQ(reader.message()->text, second.text) << until;
    EXPECT_EQ(reader.message()->place, 9);
    EXPECT_EQ(reader.read(), 1);
  }
}

TEST(MessageReader, NeverReadsBehindTheLastPage) {
  MessageReader reader;
  reader.begin();
  const std::int32_t longest = 262'144 * 127 + 65'536;
  int read = 0;
  for (; reader.next() && read < 100; ++read) {
    ASSERT_LT(*reader.next(), pendant::kPages);
    reader.on_page(*reader.next() == 16 ? longest : 0x20'20'20);
  }
  EXPECT_EQ(reader.message()->text.size(), pendant::kMaxMessageText);
}

TEST(MessageReader, SaysInWordsWhatTheMessageIs) {
  const auto text = [](MessageKind kind, const std::string& said) {
    return message_text({.header = {.number = 1, .kind = kind, .length = 0}, .place = 0, .text = said});
  };
  EXPECT_EQ(text(MessageKind::kNone, ""), "no message");
  EXPECT_EQ(text(MessageKind::kAlarm, "no part"), "alarm: no part");
  EXPECT_EQ(text(MessageKind::kStopped, ""), "stopped: the arm did not carry out this line");
  EXPECT_EQ(text(MessageKind::kMessage, "a\x1B[2J"), "message: \"a\\x1B[2J\"") << "nothing controls the terminal";
}

}  // namespace
}  // namespace armature::cosim
