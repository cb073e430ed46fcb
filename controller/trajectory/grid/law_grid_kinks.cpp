// The limits where two segments meet, in a rounded corner and without one.
#include <algorithm>
#include <array>
#include <cmath>

#include "controller/base/math.hpp"
#include "controller/base/timebase.hpp"
#include "controller/trajectory/cartesian/path_corners.hpp"
#include "controller/trajectory/grid/law_grid.hpp"
#include "controller/trajectory/grid/tool_limits.hpp"

namespace armature {
namespace {

constexpr double kJumpShare = 0.3;      // of an acceleration, for the change of direction at a smooth joint
constexpr double kBendJumpShare = 0.5;  // of a jerk, for the change of curvature there
constexpr double kNoise = 0.02;         // of a second derivative

}  // namespace

// Where the direction changes a little between two segments, the speeds jump within a tick.
void LawGrid::pass_smoothly(const CartesianPlan& plan, Point& before, Point& after) const noexcept {
  const CartesianSegment &a = plan.segments[piece_.segment - 1], &b = plan.segments[piece_.segment];
  const PathDirection from = direction_at(a, 1.0), to = direction_at(b, 0.0);
  const Kink kink{.move = (to.move - from.move).norm(),
                  .turn_per_mm = (to.turn_per_mm - from.turn_per_mm).norm(),
                  .most = larger(a.limits, b.limits)};
  double speed = kLargestPathLimit;
  const auto limit = [&speed](double jump, double accel) {
    if (jump > 0.0) speed = std::min(speed, kJumpShare * accel * kTickSeconds / jump);
  };
  limit(kink.move, kink.most.accel_mm_s2);
  limit(kink.turn_per_mm, kink.most.turn_accel_rad_s2);
  const bool smooth = a.profile == ProfileKind::kSCurve && b.profile == ProfileKind::kSCurve;
  const auto limit_change = [&speed](double jump, double bend_jump, double jerk) {
    if (jump > 0.0) speed = std::min(speed, kJumpShare * jerk * math::square(kTickSeconds) / jump);
    if (bend_jump > 0.0) speed = std::min(speed, std::sqrt(kBendJumpShare * jerk * kTickSeconds / bend_jump));
  };
  if (smooth) {
    limit_change(kink.move, (bend_at(b, 0.0) - bend_at(a, 1.0)).norm(), kink.most.jerk_mm_s3);
    limit_change(kink.turn_per_mm, 0.0, kink.most.turn_jerk_rad_s3);
  }
  if (with_ == With::kJoints) {
    // Differences have rounding, so small jumps are those of the tool only.
    for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
      const double jump = std::fabs(after.slope[axis] - before.slope[axis]);
      if (jump > 1e-6 * std::fabs(after.slope[axis])) limit(jump, accel_rad_s2_[axis]);
      const double bend = std::fabs(after.bend[axis] - before.bend[axis]);
      const bool real = bend > kNoise * (std::fabs(after.bend[axis]) + std::fabs(before.bend[axis]));
      if (smooth && real && jerk_rad_s3_[axis] > 0.0) limit_change(0.0, bend, jerk_rad_s3_[axis]);
    }
  }
  for (LawLimits* limits : {&before.limits, &after.limits}) {
    limits->most_square = std::min(limits->most_square, math::square(speed));
  }
  leave_room(kink, before, after);
}

// In a rounded corner the tool is slower than the parameter, most of all in its middle. Between two points of the grid
// the law is a line in x, and the largest x permitted is mostly below it by an eighth of its second difference. That
// may be more than kCornerShare leaves.
void LawGrid::keep_speed_between(SpeedLaw& law, Point& middle, Point& end) const noexcept {
  constexpr double kPart = 1.0 / 6.0;  // more than an eighth, because the second difference changes
  LawLimits& before = law.limits(law.size() - 1);
  const double bend = before.most_square - 2.0 * middle.limits.most_square + end.limits.most_square;
  for (LawLimits* limits : {&before, &middle.limits, &end.limits}) {
    const double room = 1.0 + kPart * bend / limits->most_square;
    limits->most_square *= std::min(1.0, 1.0 / (math::square(kCornerShare) * room));
  }
}

// The jump adds to the accelerations beside it, and the check sees the sum.
void LawGrid::leave_room(const Kink& kink, Point& before, Point& after) const noexcept {
  const double speed = std::sqrt(std::min(before.limits.most_square, after.limits.most_square));
  const auto share = [speed](double jump, double accel) {
    return std::min(kJumpShare, speed * jump / (accel * kTickSeconds));
  };
  const std::array<double, 2> of_tool{share(kink.move, kink.most.accel_mm_s2),
                                      share(kink.turn_per_mm, kink.most.turn_accel_rad_s2)};
  for (LawLimits* limits : {&before.limits, &after.limits}) {
    for (std::size_t i = 0; i < of_tool.size(); ++i) {
      LawLimits::Ellipse& ellipse = limits->ellipses[i];
      // A jump of the direction is across the path, as is the acceleration of a bend.
      const double left = ellipse.square2 > 0.0 ? math::square(1.0 - of_tool[i]) : 1.0 - math::square(of_tool[i]);
      ellipse = {ellipse.accel2 / left, ellipse.mixed / left, ellipse.square2 / left};
    }
    if (with_ != With::kJoints) continue;
    for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
      const double jump = std::fabs(after.slope[axis] - before.slope[axis]);
      LawLimits::Band& band = limits->bands[axis];
      const double left = 1.0 - share(jump, accel_rad_s2_[axis]);
      band = {band.by_accel / left, band.by_square / left};
    }
  }
}

}  // namespace armature
