// How long core 1 will need for a window of a chain.
//
// It is the work of the window, in inverse kinematics, times the time of one. The law needs them for its grid and its
// intervals: about in proportion to the set-points and, because each segment and its corner have many points however
// short they are, to the segments. The pass over the set-points needs one for each, and some at kinks of the law. Both
// differ from place to place of a path by a factor of five. So no window is expected to be easier than most are, but
// those behind a difficult one are expected to be as difficult.
#pragma once

#include <cstddef>

#include "controller/trajectory/plan/cartesian_planner.hpp"

namespace armature {

class PlanningCost {
 public:
  // The planner has planned its plan() in `ticks`. A plan that continues another one has `added` further segments.
  void measure(double ticks, const CartesianPlanner& planner, std::size_t added) noexcept;

  // The ticks that core 1 will need for `segments` segments which the tool passes in `motion_ticks`, if the first pass
  // finds no excess. A sum of such parts is the time for all of them. Valid after measure().
  [[nodiscard]] double ticks(double motion_ticks, double segments) const noexcept;

 private:
  double ticks_per_inverse_ = 0.0;
  double law_per_point_ = 0.0, pass_per_tick_ = 0.0;  // inverse kinematics
};

}  // namespace armature
