#include "cosim/iss/debug/protocol/packet.hpp"

#include <fmt/format.h>

#include "cosim/iss/debug/protocol/hex.hpp"

namespace armature::cosim::iss {
namespace {

constexpr char kCtrlC = '\x03';
constexpr char kEscape = '}';
constexpr char kEscapeBit = 0x20;

std::uint8_t checksum(std::string_view text) {
  unsigned sum = 0;
  for (const char character : text) sum += static_cast<unsigned char>(character);
  return static_cast<std::uint8_t>(sum);
}

std::string without_escapes(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escaped = text[i] == kEscape && i + 1 < text.size();
    plain += escaped ? static_cast<char>(text[++i] ^ kEscapeBit) : text[i];
  }
  return plain;
}

}  // namespace

std::string packet_of(std::string_view payload) {
  std::string text;
  for (const char character : payload) {
    // '*' would begin a run length.
    const bool special = character == '#' || character == '$' || character == kEscape || character == '*';
    if (special) text += kEscape;
    text += special ? static_cast<char>(character ^ kEscapeBit) : character;
  }
  return fmt::format("${}#{:02x}", text, checksum(text));
}

std::optional<PacketReader::Item> PacketReader::next() {
  // Acknowledgements say nothing new: the connection loses nothing.
  bytes_.erase(0, bytes_.find_first_not_of("+-"));
  if (bytes_.empty()) return std::nullopt;
  if (bytes_.front() != '$') {
    const auto kind = bytes_.front() == kCtrlC ? Item::Kind::kInterrupt : Item::Kind::kForeign;
    bytes_.erase(0, 1);
    return Item{kind};
  }
  constexpr std::size_t kSumDigits = 2;
  const std::size_t end = bytes_.find('#');
  if (end == std::string::npos ? bytes_.size() > 2 * kLongestPayload : end > 2 * kLongestPayload) {
    bytes_.clear();
    return Item{Item::Kind::kBad};
  }
  if (end == std::string::npos || end + kSumDigits >= bytes_.size()) return std::nullopt;
  const std::string text = bytes_.substr(1, end - 1);
  const auto sum = number_of_hex(std::string_view{bytes_}.substr(end + 1, kSumDigits));
  bytes_.erase(0, end + 1 + kSumDigits);
  if (sum != checksum(text)) return Item{Item::Kind::kBad};
  return Item{Item::Kind::kPacket, without_escapes(text)};
}

}  // namespace armature::cosim::iss
