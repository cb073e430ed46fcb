// A text of any length as messages of a channel: parts, all full but the last one.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cosim/snapshot/message_channel.hpp"

namespace armature::cosim {

struct TextPart {
  std::uint32_t size = 0;
  std::array<char, 60'000> text{};
};

// Returns false when the other end is closed.
inline bool send_text(MessageChannel& channel, std::string_view text) {
  TextPart part;
  do {
    part.size = static_cast<std::uint32_t>(text.copy(part.text.data(), part.text.size()));
    if (!channel.send(part)) return false;
    text.remove_prefix(part.size);
  } while (part.size == part.text.size());
  return true;
}

// Nothing: the other end is closed.
[[nodiscard]] inline std::optional<std::string> receive_text(MessageChannel& channel) {
  std::string text;
  while (const auto part = channel.receive<TextPart>()) {
    text.append(part->text.data(), part->size);
    if (part->size < part->text.size()) return text;
  }
  return std::nullopt;
}

}  // namespace armature::cosim
