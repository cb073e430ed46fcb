#include "cosim/iss/debug/protocol/packet.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cosim/iss/debug/protocol/hex.hpp"

namespace armature::cosim::iss {
namespace {

using testing::ElementsAre;
using ItemKind = PacketReader::Item::Kind;

std::vector<ItemKind> kinds(std::string_view bytes) {
  PacketReader reader;
  reader.append(bytes);
  std::vector<ItemKind> found;
  while (const auto item = reader.next()) found.push_back(item->kind);
  return found;
}

TEST(Packet, HasAChecksumOfTwoDigits) {
  EXPECT_EQ(packet_of("OK"), "$OK#9a");
  EXPECT_EQ(packet_of(""), "$#00");
}

TEST(Packet, IsReadAsItIsWritten) {
  std::string payload;
  for (int character = 0; character < 256; ++character) payload += static_cast<char>(character);
  PacketReader reader;
  reader.append(packet_of(payload));
  EXPECT_EQ(reader.next()->payload, payload);
  EXPECT_FALSE(reader.next());
}

TEST(Packet, IsCompleteWhenItsLastByteHasArrived) {
  PacketReader reader;
  std::string text = "+$qC#b4";
  for (const char byte : text) {
    EXPECT_FALSE(reader.next());
    reader.append({&byte, 1});
  }
  EXPECT_EQ(reader.next()->payload, "qC");
}

TEST(Packet, OfAWrongChecksumIsBadAndTheNextOneIsRead) {
  EXPECT_THAT(kinds("$qC#b5$qC#zz$qC#b4"), ElementsAre(ItemKind::kBad, ItemKind::kBad, ItemKind::kPacket));
}

TEST(Packet, IsNoLongerThanAgreed) {
  EXPECT_THAT(kinds("$" + std::string(2 * kLongestPayload + 1, 'a')), ElementsAre(ItemKind::kBad));
  EXPECT_THAT(kinds(packet_of(std::string(2 * kLongestPayload + 1, 'a'))), ElementsAre(ItemKind::kBad));
}

TEST(Packet, MayBeInterruptedByCtrlC) {
  EXPECT_THAT(kinds("-\x03$c#63\x03"), ElementsAre(ItemKind::kInterrupt, ItemKind::kPacket, ItemKind::kInterrupt));
}

TEST(Packet, OfAWebPageIsForeign) {
  EXPECT_THAT(kinds("G"), ElementsAre(ItemKind::kForeign));
}

TEST(Hex, WritesNumbersInTheByteOrderOfTheTarget) {
  EXPECT_EQ(to_hex(0x12345678u, 4), "78563412");
  EXPECT_EQ(to_hex(std::string_view{"tick"}), "7469636b");
}

TEST(Hex, ReadsNothingButDigits) {
  EXPECT_EQ(number_of_hex("c0b488"), 0xc0b488u);
  for (const char* wrong : {"", "-1", "0x1", "1g", "11112222333344445"}) EXPECT_FALSE(number_of_hex(wrong)) << wrong;
  EXPECT_THAT(bytes_of_hex("00ff").value(), ElementsAre(0, 255));
  for (const char* wrong : {"0", "0g", "0-1 "}) EXPECT_FALSE(bytes_of_hex(wrong)) << wrong;
}

}  // namespace
}  // namespace armature::cosim::iss
