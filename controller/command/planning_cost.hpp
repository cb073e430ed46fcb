// How long core 1 will need for a window of a chain, estimated from the plans before it.
#pragma once

#include "controller/trajectory/plan/cartesian_planner.hpp"

namespace armature {

class PlanningCost {
 public:
  // The planner has planned its plan() in `ticks`.
  void measure(double ticks, const CartesianPlanner& planner) noexcept;
  // A window came too late: the next one is expected to be twice as difficult as this one was.
  void double_it() noexcept { ticks_per_point_ *= 2.0; }

  // The ticks that core 1 will need for `segments` segments which the tool passes in `motion_ticks`. A sum of such
  // parts is the time for all of them.
  [[nodiscard]] double ticks(double motion_ticks, double segments) const noexcept;

 private:
  static constexpr double kLeast = 1e-5;
  double ticks_per_point_ = kLeast;
};

}  // namespace armature
