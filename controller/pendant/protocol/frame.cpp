#include "controller/pendant/protocol/frame.hpp"

#include <algorithm>

#include "controller/pendant/protocol/crc8.hpp"

namespace armature::pendant {
namespace {

constexpr std::uint8_t kReplyBit = 0x80;
constexpr std::size_t kPayloadAt = 3, kHighestAt = 6, kCrcAt = 7;

std::uint8_t head(Kind kind, std::uint8_t sequence) {
  return static_cast<std::uint8_t>(static_cast<unsigned>(kind) << 4 | (sequence & 0xFu));
}

FrameBytes with_crc(FrameBytes bytes) {
  bytes[kCrcAt] = crc8(std::span{bytes}.first<kCrcAt>());
  return bytes;
}

std::int32_t payload_of(std::span<const std::uint8_t, kFrameBytes> bytes) {
  std::uint32_t word = 0;
  for (std::size_t at = kHighestAt; at >= kPayloadAt; --at) word = word << 8 | bytes[at];
  return static_cast<std::int32_t>(word);
}

bool in_range(std::int32_t payload) {
  return payload >= -kLargestPayload && payload <= kLargestPayload;
}

bool valid_command(std::span<const std::uint8_t, kFrameBytes> bytes) {
  const OpcodeRule* rule = find_rule(bytes[1]);
  return rule != nullptr && !rule->reply_only && bytes[2] >= rule->parameter.min && bytes[2] <= rule->parameter.max &&
         in_range(payload_of(bytes));
}

bool valid_bulk(std::span<const std::uint8_t, kFrameBytes> bytes) {
  return std::ranges::all_of(bytes.subspan<1, BulkFrame::kCharacters>(), [](std::uint8_t c) { return c < 0x80; });
}

bool valid_reply(std::span<const std::uint8_t, kFrameBytes> bytes) {
  return (bytes[1] & kReplyBit) != 0 && find_rule(static_cast<std::uint8_t>(bytes[1] & ~kReplyBit)) != nullptr &&
         bytes[2] < kStatusNames.size() && in_range(payload_of(bytes));
}

bool valid_telemetry(std::span<const std::uint8_t, kFrameBytes> bytes) {
  return bytes[1] == static_cast<std::uint8_t>(Opcode::kGetStatus) && bytes[2] < kPages && in_range(payload_of(bytes));
}

}  // namespace

FrameBytes encode(const Frame& frame) noexcept {
  const std::uint8_t reply = frame.kind == Kind::kReply ? kReplyBit : std::uint8_t{0};
  FrameBytes bytes{head(frame.kind, frame.sequence),
                   static_cast<std::uint8_t>(static_cast<std::uint8_t>(frame.opcode) | reply), frame.parameter};
  const auto word = static_cast<std::uint32_t>(frame.payload);
  for (std::size_t i = 0; i < sizeof word; ++i) bytes[kPayloadAt + i] = static_cast<std::uint8_t>(word >> (8 * i));
  return with_crc(bytes);
}

FrameBytes encode(const BulkFrame& frame) noexcept {
  FrameBytes bytes{head(Kind::kBulk, frame.sequence)};
  std::ranges::copy(frame.text, bytes.begin() + 1);
  return with_crc(bytes);
}

bool valid(std::span<const std::uint8_t, kFrameBytes> bytes, End end) noexcept {
  const bool to_controller = end == End::kController;
  bool well_formed = false;
  switch (static_cast<Kind>(bytes[0] >> 4)) {
    case Kind::kCommand:
      well_formed = to_controller && valid_command(bytes);
      break;
    case Kind::kBulk:
      well_formed = to_controller && valid_bulk(bytes);
      break;
    case Kind::kReply:
      well_formed = !to_controller && valid_reply(bytes);
      break;
    case Kind::kTelemetry:
      well_formed = !to_controller && valid_telemetry(bytes);
      break;
  }
  return well_formed && crc8(bytes.first<kCrcAt>()) == bytes[kCrcAt];
}

Kind kind_of(const FrameBytes& bytes) noexcept {
  return static_cast<Kind>(bytes[0] >> 4);
}

Frame decode(const FrameBytes& bytes) noexcept {
  return {.kind = kind_of(bytes),
          .sequence = static_cast<std::uint8_t>(bytes[0] & 0xFu),
          .opcode = static_cast<Opcode>(bytes[1] & ~kReplyBit),
          .parameter = bytes[2],
          .payload = payload_of(bytes)};
}

BulkFrame decode_bulk(const FrameBytes& bytes) noexcept {
  BulkFrame frame{.sequence = static_cast<std::uint8_t>(bytes[0] & 0xFu)};
  std::copy_n(bytes.begin() + 1, BulkFrame::kCharacters, frame.text.begin());
  return frame;
}

const OpcodeRule* find_rule(std::uint8_t code) noexcept {
  const auto* rule = std::ranges::find(kOpcodeRules, static_cast<Opcode>(code), &OpcodeRule::opcode);
  return rule == kOpcodeRules.end() ? nullptr : rule;
}

}  // namespace armature::pendant
