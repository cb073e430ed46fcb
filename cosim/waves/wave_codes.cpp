#include "cosim/waves/wave_codes.hpp"

namespace armature::cosim {
namespace {

constexpr char kFirstDigit = '!';
constexpr std::size_t kDigits = 94;
constexpr std::size_t kMaxDigits = 3;  // 94^3 places are 3 MB

}  // namespace

std::optional<std::size_t> WaveCodes::place(std::string_view code) {
  if (code.size() > kMaxDigits) return std::nullopt;
  std::size_t number = 0;
  for (const char c : code) {
    if (c < kFirstDigit || c > '~') return std::nullopt;
    number = number * kDigits + static_cast<std::size_t>(c - kFirstDigit) + 1;
  }
  return number;
}

std::uint32_t WaveCodes::add(std::string_view code) {
  if (const std::uint32_t known = find(code); known != kNone) return known;
  if (const auto at = place(code)) {
    if (by_place_.size() <= *at) by_place_.resize(*at + 1, kNone);
    by_place_[*at] = size_;
  } else {
    others_.emplace(code, size_);
  }
  return size_++;
}

std::uint32_t WaveCodes::find(std::string_view code) const {
  if (const auto at = place(code)) return *at < by_place_.size() ? by_place_[*at] : kNone;
  const auto found = others_.find(code);
  return found == others_.end() ? kNone : found->second;
}

}  // namespace armature::cosim
