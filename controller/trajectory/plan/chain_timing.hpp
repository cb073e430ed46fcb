// The timing of a chain with an S-curve: which corners are rounded, the fastest law of each segment between them, and
// the start of each segment.
//
// A corner is rounded only if that makes the chain shorter. If the blend costs its segments more time than the overlap
// saves, the corner is an exact stop.
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
#include "controller/trajectory/plan/chain_law.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

class ChainTiming {
 public:
  // Reads profiles and blends from the requests of a plan that has been laid out.
  void begin(std::span<const SegmentRequest> chain) noexcept;
  // From here on all corners are exact stops.
  void disable_blends() noexcept;

  // Chooses the corners of `plan` in order: a corner is rounded if its two segments then take less time together. Sets
  // the durations of the segments and a stretch of 1. Call schedule() next.
  void choose_corners(CartesianPlan& plan) noexcept;

  // True when a corner was rounded.
  [[nodiscard]] bool rounded() const noexcept { return rounded_; }
  // Lower bound of the duration of a chain with exact stops, from the last choose_corners() that could plan all
  // segments.
  [[nodiscard]] Ticks least_exact() const noexcept { return least_exact_; }

  // Slows each segment's fastest law down by its `stretch`, to whole ticks, and sets the start of each segment. Returns
  // the first segment that takes longer than kLongestSegment, or nothing.
  [[nodiscard]] std::optional<std::size_t> schedule(CartesianPlan& plan) const noexcept;

 private:
  [[nodiscard]] bool may_round(const CartesianPlan& plan, std::size_t corner) const noexcept;
  void plan_law(CartesianPlan& plan, std::size_t index) noexcept;
  [[nodiscard]] Ticks time_of_pair(const CartesianPlan& plan, std::size_t first) const noexcept;

  std::array<ProfileKind, CartesianPlan::kMaxSegments> profile_{};
  std::array<double, CartesianPlan::kMaxSegments> blend_mm_{};  // [i]: requested between segments i and i + 1
  std::array<Corner, CartesianPlan::kMaxSegments> corner_{};    // [i]: chosen there
  std::array<TimeLaw, CartesianPlan::kMaxSegments> fastest_{};  // before stretching
  bool rounded_ = false;
  Ticks least_exact_{};
};

}  // namespace armature
