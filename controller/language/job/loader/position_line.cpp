#include "controller/language/job/loader/position_line.hpp"

#include <algorithm>

#include "controller/language/job/memory/number_text.hpp"

namespace armature::job {
namespace {

constexpr std::size_t kMaxPositionDigits = 5;  // of the number

constexpr std::size_t largest_number(PositionLetter letter) noexcept {
  return letter >= PositionLetter::kP ? 255 : 65'534;
}

}  // namespace

bool PositionLine::fail(std::size_t at, const DiagnosticText& text) noexcept {
  problem_ = {.column = at + 1, .text = text};
  return false;
}

bool PositionLine::read() noexcept {
  if (!read_name() || !read_values() || !read_end()) return false;
  if (holds_joints(position_.frame)) position_.rconf = 0;
  return true;
}

// Up to the equals sign.
bool PositionLine::read_name() noexcept {
  at_ = place_where(line_, [](char character) { return character < 'A' || character > 'Z'; });
  const auto letter = named<PositionLetter>(kPositionNames, part(line_, 0, at_));
  if (!letter) return fail(0, "expected a position: C, BC, EC, P, BP or EX and a number");
  std::uint32_t number = 0;
  const std::size_t digits = at_;
  for (; at_ < line_.size() && is_digit(line_[at_]) && at_ < digits + kMaxPositionDigits; ++at_) {
    number = 10 * number + static_cast<std::uint32_t>(line_[at_] - '0');
  }
  if (at_ == digits) return fail(at_, "expected the number of the position");
  if (!is_here('=')) return fail(at_, "expected '='");
  const std::size_t largest = largest_number(*letter);
  if (number > largest) return fail(digits, DiagnosticText{"expected a number up to "} << largest);
  position_.letter = *letter;
  position_.number = static_cast<std::uint16_t>(number);
  position_.digits = static_cast<std::uint8_t>(at_ - digits);
  ++at_;
  return true;
}

// Between commas.
bool PositionLine::read_values() noexcept {
  if (!read_value()) return false;
  while (is_here(',')) {
    ++at_;
    if (!read_value()) return false;
  }
  return true;
}

bool PositionLine::read_value() noexcept {
  const std::size_t blanks = at_;
  while (is_here(' ')) ++at_;
  const auto value = read_number(part(line_, at_));
  if (!value || value->exponent_form != 0) return fail(at_, "expected a number");
  if (position_.count == position_.value.size()) return fail(at_, "a position has at most 6 values");
  position_.gap[position_.count] = static_cast<std::uint8_t>(std::min<std::size_t>(at_ - blanks, 255));
  position_.form[position_.count] = value->form;
  position_.value[position_.count++] = value->value;
  at_ += value->size;
  return true;
}

bool PositionLine::read_end() noexcept {
  const std::size_t end = place_where(
      line_, [](char character) { return character != ' '; }, at_);
  if (end < line_.size()) return fail(end, "expected a comma or the end of the line");
  position_.blanks_after = static_cast<std::uint8_t>(std::min<std::size_t>(line_.size() - at_, 255));
  const bool of_arm = position_.letter == PositionLetter::kC || position_.letter == PositionLetter::kP;
  if (of_arm && position_.count != 6) return fail(at_, "a position of the arm has 6 values");
  return true;
}

}  // namespace armature::job
