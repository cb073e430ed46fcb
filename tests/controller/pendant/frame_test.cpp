#include "controller/pendant/protocol/frame.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "controller/pendant/protocol/crc8.hpp"
#include "tests/controller/pendant/pendant_draws.hpp"

namespace armature::pendant {
namespace {

using armature::test::SplitMix;

FrameBytes with_new_crc(FrameBytes bytes) {
  bytes[7] = crc8(std::span{bytes}.first<7>());
  return bytes;
}

// The three frames that the protocol's definition prints.
constexpr FrameBytes kServoOn{0xA1, 0x05, 0x01, 0x00, 0x00, 0x00, 0x00, 0xB1};
constexpr FrameBytes kJogJoint3{0xA2, 0x20, 0x02, 0x3C, 0xF6, 0xFF, 0xFF, 0x3E};
constexpr FrameBytes kJogReply{0x52, 0xA0, 0x00, 0x00, 0x00, 0x00, 0x00, 0x9D};

TEST(PendantFrame, EncodesThePrintedExamples) {
  EXPECT_EQ(encode(Frame{.sequence = 1, .opcode = Opcode::kServo, .parameter = 1}), kServoOn);
  EXPECT_EQ(encode(Frame{.sequence = 2, .opcode = Opcode::kJogContinuous, .parameter = 2, .payload = -2'500}),
            kJogJoint3);
  EXPECT_EQ(encode(Frame{.kind = Kind::kReply, .sequence = 2, .opcode = Opcode::kJogContinuous}), kJogReply);
}

TEST(PendantFrame, DecodesThePrintedExamples) {
  EXPECT_EQ(decode(kJogJoint3),
            (Frame{.sequence = 2, .opcode = Opcode::kJogContinuous, .parameter = 2, .payload = -2'500}));
  EXPECT_EQ(decode(kJogReply), (Frame{.kind = Kind::kReply, .sequence = 2, .opcode = Opcode::kJogContinuous}));
  EXPECT_EQ(decode(kJogReply).status(), Status::kOk);
}

TEST(PendantFrame, EachEndAcceptsOnlyTheFramesOfTheOther) {
  EXPECT_TRUE(valid(kServoOn, End::kController));
  EXPECT_FALSE(valid(kServoOn, End::kPendant));
  EXPECT_TRUE(valid(kJogReply, End::kPendant));
  EXPECT_FALSE(valid(kJogReply, End::kController));
  const FrameBytes page = encode(Frame{.kind = Kind::kTelemetry, .opcode = Opcode::kGetStatus, .parameter = 14});
  EXPECT_TRUE(valid(page, End::kPendant));
  EXPECT_FALSE(valid(page, End::kController));
  const FrameBytes bulk = encode(BulkFrame{.sequence = 3, .text = {'M', 'O', 'V', 'J', ' ', 'C'}});
  EXPECT_TRUE(valid(bulk, End::kController));
  EXPECT_FALSE(valid(bulk, End::kPendant));
}

TEST(PendantFrame, EveryFrameDecodesToWhatWasEncoded) {
  SplitMix random{0x15A1};
  for (int draw = 0; draw < 20'000; ++draw) {
    const Frame command = test::random_command(random);
    ASSERT_TRUE(valid(encode(command), End::kController)) << find_rule(static_cast<std::uint8_t>(command.opcode))->name;
    ASSERT_EQ(decode(encode(command)), command);
    const BulkFrame bulk = test::random_bulk(random);
    ASSERT_TRUE(valid(encode(bulk), End::kController));
    ASSERT_EQ(decode_bulk(encode(bulk)), bulk);
  }
}

TEST(PendantFrame, RejectsWhatTheTableDoesNotHaveAlthoughTheCrcIsRight) {
  struct Case {
    const char* what;
    FrameBytes bytes;
  };
  const Case cases[]{
      {"an unused kind", {0xB1, 0x05, 0x01}},
      {"a kind that begins with the byte of the emergency stop", {0xE1, 0x05, 0x01}},
      {"an unknown opcode", {0xA1, 0x06 + 0x60, 0x01}},
      {"the opcode 0", {0xA1, 0x00, 0x00}},
      {"an opcode that only replies have", {0xA1, 0x4F, 0x00}},
      {"a reply's opcode in a command", {0xA1, 0x85, 0x01}},
      {"a parameter above its range", {0xA1, 0x05, 0x02}},
      {"a parameter below its range", {0xA1, 0x08, 0x59, 0x09, 0x57, 0x0E}},
      {"a payload above 2^27 - 1", {0xA1, 0x7F, 0x00, 0x00, 0x00, 0x00, 0x08}},
      {"the payload -2^27", {0xA1, 0x7F, 0x00, 0x00, 0x00, 0x00, 0xF8}},
      {"a character above 127", {0xD1, 'A', 'B', 'C', 'D', 'E', 0x80}},
  };
  for (const Case& c : cases) EXPECT_FALSE(valid(with_new_crc(c.bytes), End::kController)) << c.what;
  EXPECT_FALSE(valid(with_new_crc({0x51, 0x05, 0x00}), End::kPendant)) << "a command's opcode in a reply";
  EXPECT_FALSE(valid(with_new_crc({0x51, 0x85, 0x0E}), End::kPendant)) << "an unknown status";
  EXPECT_FALSE(valid(with_new_crc({0x61, 0x02, kPages}), End::kPendant)) << "an unknown page";
}

TEST(PendantFrame, EveryRuleIsFoundByItsCode) {
  for (const OpcodeRule& rule : kOpcodeRules) EXPECT_EQ(find_rule(static_cast<std::uint8_t>(rule.opcode)), &rule);
  EXPECT_EQ(find_rule(0x00), nullptr);
  EXPECT_EQ(find_rule(0x80), nullptr);
}

}  // namespace
}  // namespace armature::pendant
