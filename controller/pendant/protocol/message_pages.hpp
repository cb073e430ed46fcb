// The present message of a program as pages of the telemetry, for both ends of the line.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "controller/pendant/protocol/frame_table.hpp"

namespace armature::pendant {

inline constexpr std::size_t kCharactersOfPage = 3;
// As many pages as the longest message needs.
inline constexpr std::size_t kTextPages = kPages - static_cast<std::size_t>(Page::kMessageText);
inline constexpr std::size_t kMaxMessageText = kTextPages * kCharactersOfPage;

// What the page `message` says.
struct MessageHeader {
  std::uint16_t number = 0;  // of messages since the start of the controller, modulo 65536
  MessageKind kind = MessageKind::kNone;
  std::uint8_t length = 0;  // of the text

  friend constexpr bool operator==(const MessageHeader&, const MessageHeader&) noexcept = default;
};

[[nodiscard]] constexpr std::int32_t page_of(const MessageHeader& header) noexcept {
  return kMessageNumber.with(header.number) + kMessageKind.with(static_cast<std::int32_t>(header.kind)) +
         kMessageLength.with(header.length);
}

[[nodiscard]] constexpr MessageHeader message_header(std::int32_t page) noexcept {
  return {.number = static_cast<std::uint16_t>(kMessageNumber.of(page)),
          .kind = static_cast<MessageKind>(kMessageKind.of(page)),
          .length = static_cast<std::uint8_t>(kMessageLength.of(page))};
}

// The value of the page with the characters from kCharactersOfPage * `index` on; 0 stands for those behind the end.
[[nodiscard]] constexpr std::int32_t text_page(std::string_view text, std::size_t index) noexcept {
  std::int32_t value = 0;
  for (std::size_t i = 0; i < kCharactersOfPage; ++i) {
    const std::size_t at = kCharactersOfPage * index + i;
    if (at < text.size()) value |= static_cast<std::int32_t>(static_cast<std::uint8_t>(text[at])) << (8 * i);
  }
  return value;
}

[[nodiscard]] constexpr std::array<char, kCharactersOfPage> characters_of(std::int32_t page) noexcept {
  std::array<char, kCharactersOfPage> characters{};
  for (std::size_t i = 0; i < kCharactersOfPage; ++i) characters[i] = static_cast<char>(page >> (8 * i) & 0xFF);
  return characters;
}

}  // namespace armature::pendant
