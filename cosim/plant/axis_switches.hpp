// The home switch and the two limit switches of an axis. A switch is active where the encoder shows a joint angle in
// its range: the home switch between two angles, a limit switch from its angle to the end of the travel.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "controller/base/units.hpp"
#include "cosim/plant/subcounts.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

class AxisSwitches {
 public:
  AxisSwitches(const AxisSpec& spec, double joint_deg_per_count) {
    constexpr double kEnd = std::numeric_limits<double>::infinity();
    if (const auto& deg = spec.home_switch_deg) home_ = counts_between(deg->front(), deg->back(), joint_deg_per_count);
    if (const auto& deg = spec.limit_switch_deg) {
      limit_neg_ = counts_between(-kEnd, deg->front(), joint_deg_per_count);
      limit_pos_ = counts_between(deg->back(), kEnd, joint_deg_per_count);
    }
  }

  // Whether every switch has one level at all counts between the two.
  [[nodiscard]] bool are_steady(Counts from, Counts to) const {
    return home_.is_steady(from, to) && limit_neg_.is_steady(from, to) && limit_pos_.is_steady(from, to);
  }

  // The counts around this one at which no switch changes.
  [[nodiscard]] CountRange steady_around(Counts count) const {
    CountRange steady{Counts{-kFar}, Counts{kFar}};
    for (const Range& range : {home_, limit_neg_, limit_pos_}) {
      for (const Counts edge : {range.first, range.last + Counts{1}}) {  // the levels below it and from it on differ
        if (count < edge) {
          steady.max = std::min(steady.max, edge - Counts{1});
        } else {
          steady.min = std::max(steady.min, edge);
        }
      }
    }
    return steady;
  }

  [[nodiscard]] bool home(Counts count) const { return home_.has(count); }
  [[nodiscard]] bool limit_neg(Counts count) const { return limit_neg_.has(count); }
  [[nodiscard]] bool limit_pos(Counts count) const { return limit_pos_.has(count); }

 private:
  static constexpr std::int64_t kFar = std::int64_t{1} << 40;  // further than Subcounts reach

  // The counts at which a switch is active; none if `first` is behind `last`.
  struct Range {
    Counts first{kFar};
    Counts last{-kFar};

    [[nodiscard]] bool has(Counts count) const { return count >= first && count <= last; }
    [[nodiscard]] bool is_steady(Counts a, Counts b) const {
      return (a < first) == (b < first) && (a > last) == (b > last);
    }
  };

  // The counts whose angle, as a double, is between the two.
  static Range counts_between(double first_deg, double last_deg, double deg_per_count) {
    const std::int64_t sign = deg_per_count < 0 ? -1 : +1;
    const auto deg = [&](std::int64_t count) { return static_cast<double>(sign * count) * deg_per_count; };
    const std::int64_t first = first_count([&](std::int64_t count) { return deg(count) >= first_deg; });
    const std::int64_t last = first_count([&](std::int64_t count) { return deg(count) > last_deg; }) - 1;
    if (sign < 0) return {Counts{-last}, Counts{-first}};
    return {Counts{first}, Counts{last}};
  }

  // The first count at which `is_reached`, which stays true from there on.
  template <class IsReached>
  static std::int64_t first_count(IsReached is_reached) {
    std::int64_t before = -kFar, reached = kFar;
    while (reached - before > 1) {
      const std::int64_t middle = before + (reached - before) / 2;
      (is_reached(middle) ? reached : before) = middle;
    }
    return reached;
  }

  Range home_, limit_neg_, limit_pos_;
};

}  // namespace armature::cosim
