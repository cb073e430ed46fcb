// The points of the grid: their limits, their derivatives, and whether they are close enough.
#include <algorithm>
#include <array>
#include <cmath>

#include "controller/base/math.hpp"
#include "controller/base/timebase.hpp"
#include "controller/trajectory/grid/law_grid.hpp"
#include "controller/trajectory/grid/tool_limits.hpp"

namespace armature {
namespace {

constexpr double kMissedTurn_rad = 0.01;  // a change of a joint that the slopes at three points do not show
constexpr double kTicksApart = 1.0;       // shortest interval
constexpr double kRounding_rad = 1e-14;   // of a second difference
// A jerk of a joint makes a point slower than its other limits by no more than this, in squares of speeds: beside a
// singularity differences over a whole interval say too little.
constexpr double kSlowest = 100.0;
constexpr int kMaxDeltas = 12;

}  // namespace

LawLimits LawGrid::tool_limits(const CartesianPlan& plan, double s) const noexcept {
  const CartesianSegment& segment = plan.segments[piece_.segment];
  if (piece_.part == Part::kBetween) {
    return limits_of_tool(segment, std::clamp((s - segment.from) / segment.length, 0.0, 1.0), run_length_);
  }
  return limits_in_corner(plan, piece_.segment, owner(plan), s, run_length_);
}

JointAngles LawGrid::joints_at(const CartesianPlan& plan, double s, const JointAngles& near) noexcept {
  ++inverses_;
  const IkTracking tracking = joints_on_path(plan, arm_, s, near);
  found_ = found_ && tracking.found;
  return tracking.found ? tracking.joints : near;
}

LawGrid::Point LawGrid::point_at(const CartesianPlan& plan, double s, const JointAngles& near) noexcept {
  Point point{.s = s};
  const LawLimits tool = tool_limits(plan, s);
  point.limits = tool;
  point.square = largest_square(tool);
  if (with_ == With::kToolOnly) return point;
  const double joint_accel = owner(plan).limits.joint_accel;
  found_ = true;
  point.joints = joints_at(plan, s, near);
  const bool bent = plan.bends.at(s) != nullptr;
  point.wrist = bent ? 0.0 : arm_.wrist_sine(point.joints);
  if (!bent) least_wrist_ = std::min(least_wrist_, std::fabs(point.wrist));
  const double longest = std::max(piece_.to - piece_.from, 1e-3 * run_length_) / 16.0;
  const double shortest = 1e-13 * std::max(1.0, std::fabs(s));
  double delta = std::min(kTickSeconds * std::sqrt(point.square), longest);
  for (int i = 0; i < kMaxDeltas; ++i) {
    delta = std::max(delta, shortest);
    differentiate(plan, point, delta);
    point.limits = tool;
    for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
      const double accel_rad_s2 = joint_accel * accel_rad_s2_[axis];
      point.limits.bands[axis] = {point.slope[axis] / accel_rad_s2, point.bend[axis] / accel_rad_s2};
      const double most = speed_rad_s_[axis] / std::fabs(point.slope[axis]);
      point.limits.most_square = std::min(point.limits.most_square, math::square(most));
    }
    point.square = largest_square(point.limits);
    const double finer = kTickSeconds * std::sqrt(point.square);
    if (finer >= 0.5 * delta || delta <= shortest) break;
    delta = finer;
  }
  point.found = found_;
  if (found_ && owner(plan).profile == ProfileKind::kSCurve) add_jerk(point.limits.jerk, point);
  return point;
}

void LawGrid::differentiate(const CartesianPlan& plan, Point& point, double delta) noexcept {
  const bool forward = point.s - delta < piece_.from && !piece_.open_before;
  const bool backward = !forward && point.s + delta > piece_.to && !piece_.open_after;
  const double first_s = forward ? point.s + delta : point.s - delta;
  const double second_s = forward ? point.s + 2.0 * delta : backward ? point.s - 2.0 * delta : point.s + delta;
  const JointAngles first = joints_at(plan, first_s, point.joints);
  const JointAngles second = joints_at(plan, second_s, forward || backward ? first : point.joints);
  point.bend_noise = kRounding_rad / math::square(delta);
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    const double q = point.joints[axis].value(), a = first[axis].value(), b = second[axis].value();
    if (forward || backward) {
      const double slope = (4.0 * (a - q) - (b - q)) / (2.0 * delta);
      point.slope[axis] = forward ? slope : -slope;
      point.bend[axis] = (q - 2.0 * a + b) / math::square(delta);
    } else {
      point.slope[axis] = (b - a) / (2.0 * delta);
      point.bend[axis] = (a - 2.0 * q + b) / math::square(delta);
    }
    if (std::fabs(point.bend[axis]) < point.bend_noise) point.bend[axis] = 0.0;
  }
}

bool LawGrid::fine(const Point& a, const Point& middle, const Point& b) const noexcept {
  const double most = std::max({a.square, middle.square, b.square});
  const double step = b.s - a.s;
  if (step < 2.0 * kTicksApart * kTickSeconds * std::sqrt(std::min({a.square, middle.square, b.square}))) return true;
  if (a.wrist * middle.wrist < 0.0 || middle.wrist * b.wrist < 0.0) return false;
  double by_accel = 0.0;
  for (const LawLimits::Ellipse& e : middle.limits.ellipses) by_accel = std::max(by_accel, std::sqrt(e.accel2));
  for (const LawLimits::Band& band : middle.limits.bands) by_accel = std::max(by_accel, std::fabs(band.by_accel));
  const double speed = std::sqrt(most);
  const auto off = [](double x, double y, double z) { return std::fabs(y - 0.5 * (x + z)); };
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    const LawLimits::Band &x = a.limits.bands[axis], &y = middle.limits.bands[axis], &z = b.limits.bands[axis];
    if (off(x.by_accel, y.by_accel, z.by_accel) > kResolution * by_accel) return false;
    if (off(x.by_square, y.by_square, z.by_square) * most > kResolution) return false;
    const double slope_off = off(a.slope[axis], middle.slope[axis], b.slope[axis]);
    if (slope_off * speed > kResolution * speed_rad_s_[axis]) return false;
    const double turned = (b.joints[axis] - a.joints[axis]).value();
    const double expected = step / 6.0 * (a.slope[axis] + 4.0 * middle.slope[axis] + b.slope[axis]);
    if (std::fabs(turned - expected) > kMissedTurn_rad) return false;
  }
  for (std::size_t i = 0; i < a.limits.ellipses.size(); ++i) {
    const LawLimits::Ellipse &x = a.limits.ellipses[i], &y = middle.limits.ellipses[i], &z = b.limits.ellipses[i];
    // Of squares, and the tool has less margin than the joints.
    if (off(x.accel2, y.accel2, z.accel2) > kResolution * math::square(by_accel)) return false;
    if (off(x.square2, y.square2, z.square2) * math::square(most) > 0.5 * kResolution) return false;
  }
  return true;
}

void LawGrid::add_jerk(LawLimits::Jerk& jerk, const Point& point) const noexcept {
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    if (!(jerk_rad_s3_[axis] > 0.0)) continue;
    jerk.by_change = std::max(jerk.by_change, std::fabs(point.slope[axis]) / jerk_rad_s3_[axis]);
    jerk.by_both = std::max(jerk.by_both, 3.0 * std::fabs(point.bend[axis]) / jerk_rad_s3_[axis]);
  }
}

// The third derivatives of the joints between the last point and this one. The first point of a piece is at the same
// place as the last one of the piece before.
void LawGrid::add_jolt(SpeedLaw& law, Point& point) const noexcept {
  if (!(point.limits.jerk.by_change > 0.0) || !(point.s > last_.s) || !point.found || !last_.found) return;
  double& before = law.limits(law.size() - 1).jerk.by_speed;
  double& here = point.limits.jerk.by_speed;
  const double step = std::max(point.s - last_.s, kTickSeconds * std::sqrt(point.square));
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    if (!(jerk_rad_s3_[axis] > 0.0)) continue;
    const double change = std::fabs(point.bend[axis] - last_.bend[axis]) - point.bend_noise - last_.bend_noise;
    const double jolt = std::max(change, 0.0) / step;
    const double third = math::cbrt(jolt / jerk_rad_s3_[axis]);
    before = std::max(before, std::min(third * third, kSlowest / last_.square));
    here = std::max(here, std::min(third * third, kSlowest / point.square));
  }
}

}  // namespace armature
