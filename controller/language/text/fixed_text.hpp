// A text of limited size without a heap. What does not fit is cut off.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace armature {

template <std::size_t kSize>
class FixedText {
 public:
  static constexpr std::size_t kMaxSize = kSize;

  constexpr FixedText() noexcept = default;
  constexpr FixedText(std::string_view text) noexcept { *this << text; }  // NOLINT: a text is a text
  template <std::size_t kLiteral>
  constexpr FixedText(const char (&text)[kLiteral]) noexcept {  // NOLINT: the same
    *this << text;
  }

  [[nodiscard]] constexpr std::string_view view() const noexcept { return {characters_.data(), size_}; }
  constexpr void clear() noexcept { size_ = 0; }

  constexpr FixedText& operator<<(std::string_view text) noexcept {
    for (const char character : text) *this << character;
    return *this;
  }
  // A literal. A pointer would be measured by the C library.
  template <std::size_t kLiteral>
  constexpr FixedText& operator<<(const char (&text)[kLiteral]) noexcept {
    return *this << std::string_view{text, kLiteral - 1};
  }
  constexpr FixedText& operator<<(char character) noexcept {
    if (size_ < kSize) characters_[size_++] = character;
    return *this;
  }
  constexpr FixedText& operator<<(std::int64_t number) noexcept {
    if (number < 0) *this << '-';
    return append_digits(number < 0 ? 0 - static_cast<std::uint64_t>(number) : static_cast<std::uint64_t>(number), 1);
  }
  constexpr FixedText& operator<<(std::uint32_t number) noexcept { return append_digits(number, 1); }
  constexpr FixedText& operator<<(int number) noexcept { return *this << static_cast<std::int64_t>(number); }
  constexpr FixedText& operator<<(std::size_t number) noexcept { return append_digits(number, 1); }

  // With at least this number of digits.
  constexpr FixedText& append_digits(std::uint64_t number, int digits) noexcept {
    std::array<char, 20> reversed{};
    std::size_t count = 0;
    for (; number > 0 || static_cast<int>(count) < digits; number /= 10) {
      if (count == reversed.size()) break;
      reversed[count++] = static_cast<char>('0' + number % 10);
    }
    while (count > 0) *this << reversed[--count];
    return *this;
  }

 private:
  std::array<char, kSize> characters_{};
  std::size_t size_ = 0;
};

}  // namespace armature
