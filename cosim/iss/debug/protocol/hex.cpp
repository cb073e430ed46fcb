#include "cosim/iss/debug/protocol/hex.hpp"

#include <charconv>
#include <cstddef>

namespace armature::cosim::iss {
namespace {

constexpr std::string_view kDigits = "0123456789abcdef";

void append_hex(std::string& text, std::uint8_t byte) {
  text += kDigits[byte >> 4];
  text += kDigits[byte & 15];
}

}  // namespace

std::string to_hex(std::span<const std::uint8_t> bytes) {
  std::string text;
  text.reserve(2 * bytes.size());
  for (const std::uint8_t byte : bytes) append_hex(text, byte);
  return text;
}

std::string to_hex(std::string_view text) {
  std::string digits;
  digits.reserve(2 * text.size());
  for (const char character : text) append_hex(digits, static_cast<std::uint8_t>(character));
  return digits;
}

std::string to_hex(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) append_hex(text, static_cast<std::uint8_t>(value >> (8 * i)));
  return text;
}

std::optional<std::vector<std::uint8_t>> bytes_of_hex(std::string_view digits) {
  if (digits.size() % 2 != 0) return std::nullopt;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(digits.size() / 2);
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    const auto byte = number_of_hex(digits.substr(i, 2));
    if (!byte) return std::nullopt;
    bytes.push_back(static_cast<std::uint8_t>(*byte));
  }
  return bytes;
}

std::optional<std::uint64_t> number_of_hex(std::string_view digits) {
  std::uint64_t value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value, 16);
  if (digits.empty() || digits.front() == '-' || error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace armature::cosim::iss
