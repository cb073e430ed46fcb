// A text of limited size without a heap. What does not fit is cut off.
#pragma once

#include <array>
#include <concepts>
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
  // Which of the fixed-width types are int and long differs between processors, so each of these is one of all types.
  template <std::signed_integral Number>
  constexpr FixedText& operator<<(Number number) noexcept {
    if (number < 0) *this << '-';
    const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
    return append_digits(number < 0 ? 0 - bits : bits, 1);
  }
  template <std::unsigned_integral Number>
  constexpr FixedText& operator<<(Number number) noexcept {
    return append_digits(number, 1);
  }

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
