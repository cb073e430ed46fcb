#include "cosim/serial/line_time.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"

namespace armature::cosim {
namespace {

constexpr std::int64_t kMillion = 1'000'000;
constexpr std::int64_t kNumerator = kClkFreqHz * kMillion;  // of a half bit

}  // namespace

void LineTime::set_rate(std::int64_t baud, std::int64_t error_ppm) {
  const std::int64_t denominator = 2 * baud * (kMillion + error_ppm);
  if (denominator == denominator_) return;
  const double share = static_cast<double>(fraction_) / static_cast<double>(denominator_);
  const auto scaled = static_cast<std::int64_t>(std::floor(share * static_cast<double>(denominator)));
  fraction_ = std::min(scaled, denominator - 1);
  denominator_ = denominator;
}

void LineTime::advance_half_bits(int count) {
  fraction_ += count * kNumerator;
  whole_ += fraction_ / denominator_;
  fraction_ %= denominator_;
}

}  // namespace armature::cosim
