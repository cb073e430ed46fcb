// When the segments of a chain are driven: which corners are rounded, the fastest law of each segment between them, and
// one segment after the other.
//
// Corners are rounded only where that makes the chain shorter: a corner whose blend costs its segments more time than
// the overlap saves is an exact stop.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "controller/core/timebase.hpp"
#include "controller/core/units.hpp"
#include "controller/trajectory/path/segment_request.hpp"
#include "controller/trajectory/plan/blend.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

// The longest segment: 600 s. All its set-points, one every 50 us, are computed and checked before the first is driven,
// so a longer one would keep core 1 busy for minutes.
inline constexpr Ticks kLongestSegment{std::int64_t{600} * kClkFreqHz / kTickCycles.value()};

class ChainTiming {
 public:
  // Takes what the requests of a plan that has been laid out say about times: profiles and blends.
  void begin(std::span<const SegmentRequest> chain) noexcept;
  // From here on: exact stops everywhere.
  void forget_blends() noexcept;

  // Chooses the corners of `plan`, from the first one to the last: rounded where its two segments then take less time
  // together. Segments get their durations and a stretch of 1; schedule() comes next.
  void choose_corners(CartesianPlan& plan) noexcept;

  // Some corner has been rounded.
  [[nodiscard]] bool rounded() const noexcept { return rounded_; }
  // No chain with exact stops is shorter. Of the last choose_corners() that could plan all segments.
  [[nodiscard]] Ticks least_exact() const noexcept { return least_exact_; }

  // Slows each segment's fastest law down by its `stretch`, to whole ticks, and puts the segments one after the other.
  // The answer is the first segment that takes longer than kLongestSegment, or nothing.
  [[nodiscard]] std::optional<std::size_t> schedule(CartesianPlan& plan) const noexcept;

 private:
  [[nodiscard]] bool may_round(const CartesianPlan& plan, std::size_t corner) const noexcept;
  void plan_law(CartesianPlan& plan, std::size_t index) noexcept;
  [[nodiscard]] Ticks time_of_pair(const CartesianPlan& plan, std::size_t first) const noexcept;

  std::array<ProfileKind, CartesianPlan::kMostSegments> profile_{};
  std::array<double, CartesianPlan::kMostSegments> blend_mm_{};  // [i]: asked for between segments i and i + 1
  std::array<Corner, CartesianPlan::kMostSegments> corner_{};    // [i]: chosen there
  std::array<TimeLaw, CartesianPlan::kMostSegments> fastest_{};  // before stretching
  bool rounded_ = false;
  Ticks least_exact_{};
};

}  // namespace armature
