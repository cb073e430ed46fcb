#include "controller/trajectory/law/law_interval.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace armature {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();
constexpr int kRootSteps = 100;
// Shares of the root: it is found up to the first one, and the second one is the least rounding of a slack there.
constexpr double kRootResolution = 1e-13, kRootRounding = 1e-15;

}  // namespace

LawInterval::LawInterval(const LawLimits& near, const LawLimits& far, double step) noexcept
    : near_most_{largest_square(near)}, step_{step} {
  for (const LawLimits::Band& band : near.bands) {
    if (band.by_accel != 0.0) add(band);
  }
  for (const LawLimits::Band& band : far.bands) {
    const double by_accel = band.by_accel + 2.0 * step * band.by_square;
    if (by_accel != 0.0) {
      add({by_accel, band.by_square});
    } else if (band.by_square != 0.0) {
      near_most_ = std::min(near_most_, 1.0 / std::fabs(band.by_square));
    }
  }
  for (const LawLimits::Ellipse& e : near.ellipses) {
    if (e.accel2 > 0.0) ellipses_[ellipse_count_++] = e;
  }
  for (const LawLimits::Ellipse& e : far.ellipses) {
    const double mixed = e.mixed + 2.0 * step * e.square2;
    const double accel2 = e.accel2 + 2.0 * step * (e.mixed + mixed);
    if (!(accel2 > 0.0)) continue;
    ellipses_[ellipse_count_++] = {accel2, mixed, e.square2};
    const double left = e.square2 - mixed * (mixed / accel2);
    if (left > 0.0) near_most_ = std::min(near_most_, 1.0 / std::sqrt(left));
  }
}

void LawInterval::add(const LawLimits::Band& band) noexcept {
  bands_[band_count_++] = {-band.by_square / band.by_accel, 1.0 / std::fabs(band.by_accel)};
}

LawInterval::Accelerations LawInterval::accelerations(double square) const noexcept {
  Accelerations result{.low = -kNoBound, .high = kNoBound};
  const auto within = [&result](double low, double high, double low_slope, double high_slope) {
    if (low > result.low) {
      result.low = low;
      result.low_slope = low_slope;
    }
    if (high < result.high) {
      result.high = high;
      result.high_slope = high_slope;
    }
  };
  for (std::size_t i = 0; i < band_count_; ++i) {
    const auto [slope, half] = bands_[i];
    within(slope * square - half, slope * square + half, slope, slope);
  }
  for (std::size_t i = 0; i < ellipse_count_; ++i) {
    const LawLimits::Ellipse& e = ellipses_[i];
    // u = middle +- root, root^2 = (1 - left x^2) / accel2.
    const double slope = -e.mixed / e.accel2;
    const double left = std::max(e.square2 + e.mixed * slope, 0.0);
    const double root = std::sqrt(std::max((1.0 - left * square * square) / e.accel2, 0.0));
    const double root_slope = root > 0.0 ? -left * square / (e.accel2 * root) : -kNoBound;
    within(slope * square - root, slope * square + root, slope - root_slope, slope + root_slope);
  }
  return result;
}

LawInterval::Slack LawInterval::slack(double square, double far_square) const noexcept {
  const Accelerations a = accelerations(square);
  const double per_square = 0.5 / step_;
  Slack least{a.high - a.low, a.high_slope - a.low_slope};
  const auto also = [&least](double value, double slope) {
    if (value < least.value) least = {value, slope};
  };
  also((far_square - square) * per_square - a.low, -per_square - a.low_slope);  // brakes to far_square
  also(a.high + square * per_square, a.high_slope + per_square);                // need not stop before the far end
  return least;
}

double LawInterval::largest_near(double far_square) const noexcept {
  double high = near_most_;
  Slack at_high = slack(high, far_square);
  if (at_high.value >= 0.0) return high;
  double low = 0.0;
  Slack at_low = slack(low, far_square);
  double less = kRootRounding;
  // The slack is concave: its tangent at `high` meets 0 at or beyond the root, its chord at or before it. A tangent at
  // the root moves nowhere, although rounding may have left a slack below 0 there: a little less x is tried then.
  for (int i = 0; i < kRootSteps && high - low > kRootResolution * high; ++i) {
    const double width = high - low;
    const double tangent = at_high.slope < 0.0 ? high - at_high.value / at_high.slope : high;
    double tried = (1.0 - less) * high;
    if (tangent < tried) {
      tried = tangent;
    } else {
      less = std::min(4.0 * less, kRootResolution);
    }
    if (!(tried > low)) break;
    const Slack there = slack(tried, far_square);
    if (there.value >= 0.0) return tried;
    high = tried;
    at_high = there;
    if (high - low > 0.5 * width) narrow(low, at_low, high, at_high, far_square);
  }
  return low;
}

// Halves the interval from `low`, whose slack is at least 0, to `high`, or does more by the chord.
void LawInterval::narrow(double& low, Slack& at_low, double& high, Slack& at_high, double far_square) const noexcept {
  const double half = 0.5 * (high - low);
  const auto with = [&](double tried) {
    if (!(tried > low && tried < high)) return;
    const Slack there = slack(tried, far_square);
    (there.value >= 0.0 ? low : high) = tried;
    (there.value >= 0.0 ? at_low : at_high) = there;
  };
  with(low + (high - low) * at_low.value / (at_low.value - at_high.value));
  if (high - low > half) with(0.5 * (low + high));
}

double LawInterval::fastest_far(double near_square, double far_square) const noexcept {
  const Accelerations a = accelerations(near_square);
  return std::clamp(near_square + 2.0 * step_ * std::max(a.high, a.low), 0.0, far_square);
}

}  // namespace armature
