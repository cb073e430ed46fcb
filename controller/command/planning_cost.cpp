#include "controller/command/planning_cost.hpp"

#include <algorithm>
#include <cstdint>

namespace armature {
namespace {

// A window is computed at each of its set-points, and at about so many points for the law of a segment.
constexpr double kLawPoints = 100.0;
// Inverse kinematics at each of these points in one pass. A law of limited jerk is refined more often.
constexpr double kInverses = 1.0, kInversesOfSmoothLaw = 2.0;
// The next window may be as difficult as the ones before.
constexpr double kRemembered = 0.8;

double points(double motion_ticks, double segments) {
  return motion_ticks + kLawPoints * segments;
}

}  // namespace

void PlanningCost::measure(double ticks, const CartesianPlanner& planner) noexcept {
  const CartesianPlan& plan = planner.plan();
  double latest = 0.0;
  if (plan.continues) {
    latest = ticks / points(static_cast<double>(plan.duration.value()), static_cast<double>(plan.count));
  } else {
    // A plan from rest has a far finer law, so only its time for an inverse kinematics and its passes tell something.
    const bool smooth = planner.may_add(ProfileKind::kSCurve);
    const auto inverses = static_cast<double>(std::max<std::int64_t>(1, planner.inverses()));
    latest = ticks / inverses * (smooth ? kInversesOfSmoothLaw : kInverses) * planner.passes();
  }
  ticks_per_point_ = std::max({latest, kRemembered * ticks_per_point_, kLeast});
}

double PlanningCost::ticks(double motion_ticks, double segments) const noexcept {
  return ticks_per_point_ * points(motion_ticks, segments);
}

}  // namespace armature
