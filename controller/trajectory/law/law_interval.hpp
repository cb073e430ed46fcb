// The motions with constant acceleration over one interval of a path that keep the limits of both of its ends.
//
// From x at the near end a motion reaches x + 2 step u at the far end. Limits are checked at both ends with the same u
// (the "interpolation scheme" of Pham and Pham 2018), so they are kept to the second order of `step` between them.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "controller/trajectory/law/law_limits.hpp"

namespace armature {

class LawInterval {
 public:
  // `step` > 0: length of the interval.
  LawInterval(const LawLimits& near, const LawLimits& far, double step) noexcept;

  // The accelerations that keep the limits of both ends from x at the near end, and their derivatives by x. Empty
  // (low > high) where x is too large. The sets are convex, so `high - low` is concave in x.
  struct Accelerations {
    double low = 0.0, high = 0.0;
    double low_slope = 0.0, high_slope = 0.0;
  };
  [[nodiscard]] Accelerations accelerations(double square) const noexcept;

  // Controllable set of the reachability analysis: from every x in 0..largest_near() a motion within the limits reaches
  // an x in 0..`far_square` at the far end.
  [[nodiscard]] double largest_near(double far_square) const noexcept;

  // The x at the far end, at most `far_square`, after the fastest motion from `near_square`. That one must be at most
  // largest_near(far_square).
  [[nodiscard]] double fastest_far(double near_square, double far_square) const noexcept;

 private:
  struct Slack {
    double value = 0.0;  // >= 0: x belongs to the controllable set
    double slope = 0.0;
  };
  [[nodiscard]] Slack slack(double square, double far_square) const noexcept;
  void narrow(double& low, Slack& at_low, double& high, Slack& at_high, double far_square) const noexcept;

  // The limits of both ends, all by u and x of the near end.
  static constexpr std::size_t kBands = 2 * std::tuple_size_v<decltype(LawLimits::bands)>, kEllipses = 4;
  struct Band {  // u within slope x +- half
    double slope = 0.0, half = 0.0;
  };
  void add(const LawLimits::Band& band) noexcept;
  std::array<Band, kBands> bands_{};
  std::array<LawLimits::Ellipse, kEllipses> ellipses_{};
  std::size_t band_count_ = 0, ellipse_count_ = 0;
  double near_most_;
  double step_;
};

}  // namespace armature
