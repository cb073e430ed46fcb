#include "cosim/iss/debug/protocol/packet_words.hpp"

#include "cosim/iss/debug/protocol/hex.hpp"

namespace armature::cosim::iss {
namespace {

constexpr int kCores = 2;

}  // namespace

std::optional<std::string_view> after(std::string_view packet, std::string_view prefix) {
  if (!packet.starts_with(prefix)) return std::nullopt;
  return packet.substr(prefix.size());
}

std::pair<std::string_view, std::string_view> split(std::string_view text, char mark) {
  const std::size_t at = text.find(mark);
  if (at == std::string_view::npos) return {text, {}};
  return {text.substr(0, at), text.substr(at + 1)};
}

std::optional<std::uint32_t> word(std::string_view digits) {
  const auto number = number_of_hex(digits);
  if (!number || *number > 0xFFFF'FFFF) return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

std::optional<PacketRange> range_of(std::string_view text) {
  const auto [address, bytes] = split(text, ',');
  const auto first = word(address), size = word(bytes);
  if (!first || !size) return std::nullopt;
  return PacketRange{*first, *size};
}

std::optional<int> core_of(std::string_view thread) {
  const auto number = number_of_hex(thread);
  if (!number || *number == 0 || *number > kCores) return std::nullopt;
  return static_cast<int>(*number) - 1;
}

std::uint64_t little_endian(std::span<const std::uint8_t> bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) value |= std::uint64_t{bytes[i]} << (8 * i);
  return value;
}

std::optional<StopPoint::Kind> point_kind(char digit) {
  switch (digit) {
    case '0':
    case '1':
      return StopPoint::Kind::kBreakpoint;
    case '2':
      return StopPoint::Kind::kWrite;
    case '3':
      return StopPoint::Kind::kRead;
    case '4':
      return StopPoint::Kind::kAccess;
    default:
      return std::nullopt;
  }
}

}  // namespace armature::cosim::iss
