#include "controller/pendant/protocol/message_pages.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "controller/message/program_noted.hpp"
#include "controller/pendant/protocol/frame.hpp"

namespace armature::pendant {
namespace {

TEST(MessagePages, HaveRoomForTheLongestTextOfAProgram) {
  EXPECT_EQ(kTextPages, 22U);
  EXPECT_GE(kMaxMessageText, ProgramNoted::kMaxText);
}

TEST(MessagePages, TheHeaderHasItsBitsWhereTheProtocolSays) {
  const MessageHeader header{.number = 0x1234, .kind = MessageKind::kAlarm, .length = 64};
  EXPECT_EQ(page_of(header), 0x1234 + 65'536 * 2 + 262'144 * 64);
  EXPECT_EQ(message_header(page_of(header)), header);
  const MessageHeader largest{.number = 0xFFFF, .kind = MessageKind::kStopped, .length = 127};
  EXPECT_EQ(message_header(page_of(largest)), largest);
  EXPECT_LE(page_of(largest), kLargestPayload);
  EXPECT_EQ(page_of({}), 0) << "no message is the page of a controller that has not said anything";
}

TEST(MessagePages, ThreeCharactersAreInAPageTheFirstInTheLowestByte) {
  EXPECT_EQ(text_page("abcdefgh", 0), 'a' + 256 * 'b' + 65'536 * 'c');
  EXPECT_EQ(text_page("abcdefgh", 2), 'g' + 256 * 'h');
  EXPECT_EQ(text_page("abcdefgh", 3), 0);
  EXPECT_EQ(text_page("\xFF\xFF\xFF", 0), 0xFF'FF'FF) << "no sign";
}

TEST(MessagePages, EveryTextComesOutOfItsPagesAsItWas) {
  std::string text;
  for (std::size_t size = 0; size <= kMaxMessageText; ++size) {
    std::string read;
    for (std::size_t index = 0; index < kTextPages; ++index) {
      const std::int32_t page = text_page(text, index);
      ASSERT_GE(page, 0);
      ASSERT_LE(page, kLargestPayload);
      const auto characters = characters_of(page);
      read.append(characters.data(), characters.size());
    }
    EXPECT_EQ(read, text + std::string(kMaxMessageText - size, '\0'));
    text.push_back(static_cast<char>(1 + size * 37 % 255));
  }
}

}  // namespace
}  // namespace armature::pendant
