// A plan in one go. The controller plans in slices, between other work.
#pragma once

#include "controller/trajectory/plan/cartesian_planner.hpp"

namespace armature::test {

// Works until the plan is ready or refused.
inline CartesianPlanner::Progress finish_plan(CartesianPlanner& planner) {
  while (planner.work(10'000) == CartesianPlanner::Progress::kWorking) {
  }
  return planner.progress();
}

}  // namespace armature::test
