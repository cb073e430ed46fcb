#include "controller/activity/plans/stages/planning_cost.hpp"

#include <algorithm>
#include <cstdint>

namespace armature {
namespace {

// The law is as much work as one of so many set-points more, for each segment.
constexpr double kLawPoints = 100.0;
// In inverse kinematics. Measured in 3555 windows of random curves of lines of 0.15 to 0.4 mm at 50 to 150 mm/s (the
// draws of smooth_curves_test.cpp): 0.21 to 1.64 for the law at each of these points, 99 % below kLaw, and 1.03 to 2.56
// for the pass at each set-point, 79 % below kPass. In 1099 windows of the same curves with S-curves: 0.24 to 4.7 for
// the law, 90 % below kLawOfSmoothLaw, and 0.91 to 1.64 for the pass, 41 % below kPass.
constexpr double kLaw = 1.3, kLawOfSmoothLaw = 2.0, kPass = 1.3;
// The next moves may be as difficult as the ones before: what is known loses this share in so many moves.
constexpr double kForgotten = 0.2, kForgottenInMoves = 64.0;

double points(double motion_ticks, double segments) {
  return motion_ticks + kLawPoints * segments;
}

}  // namespace

void PlanningCost::measure(double ticks, const CartesianPlanner& planner, std::size_t added) noexcept {
  const CartesianPlan& plan = planner.plan();
  ticks_per_inverse_ = ticks / static_cast<double>(std::max<std::int64_t>(1, planner.inverses()));
  const double kept = 1.0 - kForgotten * std::min(1.0, static_cast<double>(added) / kForgottenInMoves);
  law_per_point_ = std::max(kept * law_per_point_, planner.may_add(ProfileKind::kSCurve) ? kLawOfSmoothLaw : kLaw);
  pass_per_tick_ = std::max(kept * pass_per_tick_, kPass);
  if (!plan.continues) return;  // a plan from rest has a far finer law than a window
  const CartesianPlanner::Work& work = planner.first_work();
  const auto duration = static_cast<double>(plan.duration.value());
  const double all_points = points(duration, static_cast<double>(plan.count));
  law_per_point_ = std::max(law_per_point_, static_cast<double>(work.law) / all_points);
  pass_per_tick_ = std::max(pass_per_tick_, static_cast<double>(work.pass) / duration);
}

double PlanningCost::ticks(double motion_ticks, double segments) const noexcept {
  return ticks_per_inverse_ * (law_per_point_ * points(motion_ticks, segments) + pass_per_tick_ * motion_ticks);
}

}  // namespace armature
