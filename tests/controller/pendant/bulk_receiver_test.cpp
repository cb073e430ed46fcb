#include "controller/pendant/protocol/bulk_receiver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace armature::pendant {
namespace {

BulkFrame piece(const std::string& text, std::size_t number) {
  BulkFrame frame{.sequence = static_cast<std::uint8_t>(number % kSequences)};
  for (std::size_t i = 0; i < BulkFrame::kCharacters; ++i) {
    const std::size_t at = number * BulkFrame::kCharacters + i;
    frame.text[i] = at < text.size() ? static_cast<std::uint8_t>(text[at]) : std::uint8_t{0};
  }
  return frame;
}

class BulkReceiverTest : public testing::Test {
 protected:
  std::string received() const { return {receiver_.text().begin(), receiver_.text().end()}; }

  std::array<char, 64> store_{};
  BulkReceiver receiver_{store_};
};

TEST_F(BulkReceiverTest, AcknowledgesEveryFourthFrameAndTheLastOne) {
  const std::string text = "NOP\r\nMOVJ C0001 VJ=50.00\r\nEND\r\n";  // six frames
  ASSERT_TRUE(receiver_.begin(static_cast<std::int32_t>(text.size())));
  for (std::size_t number = 0; number < 6; ++number) {
    const std::optional<Frame> reply = receiver_.push(piece(text, number));
    ASSERT_EQ(reply.has_value(), number == 3 || number == 5) << number;
    if (!reply) continue;
    EXPECT_EQ(reply->opcode, Opcode::kProgramData);
    EXPECT_EQ(reply->status(), Status::kOk);
    EXPECT_EQ(reply->payload, static_cast<std::int32_t>(number + 1));
  }
  EXPECT_TRUE(receiver_.complete());
  EXPECT_EQ(received(), text);
  Crc32 crc;
  for (const char c : text) crc.add(static_cast<std::uint8_t>(c));
  EXPECT_EQ(receiver_.check(), crc.check());
}

TEST_F(BulkReceiverTest, DropsFramesAfterAGapAndSaysWhereItIs) {
  const std::string text(48, 'x');
  ASSERT_TRUE(receiver_.begin(48));
  EXPECT_FALSE(receiver_.push(piece(text, 0)));
  const std::optional<Frame> reply = receiver_.push(piece(text, 2));
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status(), Status::kBadSequence);
  EXPECT_EQ(reply->payload, 1);
  EXPECT_FALSE(receiver_.push(piece(text, 3)));
  EXPECT_EQ(receiver_.text().size(), 6u);
}

TEST_F(BulkReceiverTest, RepeatsTheAcknowledgementInEachWindowOfUnexpectedFrames) {
  const std::string text(48, 'x');
  ASSERT_TRUE(receiver_.begin(48));
  int replies = 0;
  for (int i = 0; i < 3 * kBulkWindow; ++i) replies += receiver_.push(piece(text, 5)).has_value();
  EXPECT_EQ(replies, 3);
}

TEST_F(BulkReceiverTest, AcknowledgesAgainAfterTheEndIfTheAcknowledgementWasLost) {
  ASSERT_TRUE(receiver_.begin(3));
  ASSERT_TRUE(receiver_.push(piece("END", 0)));
  const std::optional<Frame> again = receiver_.push(piece("END", 0));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->payload, 1);
  EXPECT_EQ(received(), "END");
}

TEST_F(BulkReceiverTest, RefusesMoreThanTheStoreHolds) {
  EXPECT_FALSE(receiver_.begin(65));
  EXPECT_FALSE(receiver_.push(piece("END", 0)));
  EXPECT_TRUE(receiver_.begin(64));
  EXPECT_FALSE(receiver_.begin(0));
}

TEST_F(BulkReceiverTest, ANewTransferBeginsFromNothing) {
  ASSERT_TRUE(receiver_.begin(12));
  EXPECT_FALSE(receiver_.push(piece("abcdefghijkl", 0)));
  ASSERT_TRUE(receiver_.begin(3));
  ASSERT_TRUE(receiver_.push(piece("END", 0)));
  EXPECT_EQ(received(), "END");
  receiver_.cancel();
  EXPECT_FALSE(receiver_.complete());
}

}  // namespace
}  // namespace armature::pendant
