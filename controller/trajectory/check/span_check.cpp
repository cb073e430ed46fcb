#include "controller/trajectory/check/span_check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/base/math.hpp"
#include "controller/base/timebase.hpp"
#include "controller/trajectory/cartesian/path_corners.hpp"
#include "controller/trajectory/check/path_check.hpp"

namespace armature {
namespace {

// Of what a limit permits in a tick; see fits().
constexpr double kFit = 0.02, kJerkFit = 0.1;
// The same for a jump between two intervals of a law.
constexpr double kJoin = 1e-3, kJoinOfJerk = 0.01;
// An eighth, twice.
constexpr double kBetween = 0.25;
constexpr int kHalvingsOfTime = 40;

}  // namespace

SpanMotion motion_after(const TimeTable& table, std::size_t point) noexcept {
  const TimeTable::Point &a = table[point], &b = table[point + 1];
  if (!(b.t_s > a.t_s)) return {a.s, a.speed, 0.0, 0.0};
  return {a.s, a.speed, table.accel(point) - 0.5 * a.jerk * (b.t_s - a.t_s), a.jerk};
}

double time_at(const SpanMotion& motion, double s, double most_s) noexcept {
  double before_s = 0.0, after_s = most_s;
  for (int i = 0; i < kHalvingsOfTime; ++i) {
    const double middle_s = 0.5 * (before_s + after_s);
    (motion.after(middle_s).s < s ? before_s : after_s) = middle_s;
  }
  return after_s;
}

SpanCheck::SpanCheck(const RobotModel& robot) noexcept : axis_count_{robot.axis_count} {
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    const AxisModel& model = robot.axes[axis];
    const CheckedLimits limits{model};
    speed_[axis] = limits.speed_rad_s;
    accel_[axis] = limits.accel_rad_s2;
    jerk_[axis] = limits.jerk_rad_s3;
    lowest_rad_[axis] = model.min_rad;
    highest_rad_[axis] = model.max_rad;
  }
}

template <class Condition>
bool SpanCheck::all_curves(const CartesianSegment& segment, Condition condition) const noexcept {
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    if (!condition(axis, segment.limits.joint_accel * accel_[axis], jerk_[axis])) return false;
  }
  const PathLimits& limits = segment.limits;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!condition(SpanSample::kMove + i, limits.accel_mm_s2, limits.jerk_mm_s3)) return false;
    if (!condition(SpanSample::kTurn + i, limits.turn_accel_rad_s2, limits.turn_jerk_rad_s3)) return false;
  }
  return true;
}

bool SpanCheck::fits(const CartesianSegment& segment, const SpanMisfit& misfit, double speed) const noexcept {
  constexpr double kTick = kTickSeconds;
  const bool smooth = segment.profile == ProfileKind::kSCurve;
  return all_curves(segment, [&](std::size_t curve, double accel, double jerk) {
    const SpanCurve::End& off = misfit.off[curve];
    const double bend = off.bend * math::square(speed), slope = off.slope * speed, value = off.value;
    const double most = kFit * accel;
    if (!(bend <= most && slope <= most * kTick && value <= most * math::square(kTick))) return false;
    if (!smooth) return true;
    const double change = kJerkFit * jerk * kTick;
    return bend <= change && slope <= change * kTick && value <= change * math::square(kTick);
  });
}

SpanCheck::Rates SpanCheck::rates(const SpanCurve::Derivatives& by_s, const SpanMotion& m) noexcept {
  const double square = m.speed * m.speed;
  return {by_s.first * m.speed, by_s.second * square + by_s.first * m.accel,
          by_s.third * square * m.speed + 3.0 * by_s.second * m.speed * m.accel + by_s.first * m.jerk};
}

// By how much the rates of a curve may be larger between the ends than at them.
SpanCheck::Rates SpanCheck::most_between(const PathSpan& span, std::size_t curve, const Interval& in) noexcept {
  const SpanCurve& q = span.curves[curve];
  const SpanCurve::Derivatives& error = span.errors[curve];
  const double v = in.speed, a = in.accel, j = in.jerk, square = v * v;
  const double share = kBetween * in.duration_s * in.duration_s;
  const double third = q.most(3) * square * v + 3.0 * q.most(2) * v * a + q.most(1) * j;
  const double fourth =
      q.most(4) * square * square + 6.0 * q.most(3) * square * a + 3.0 * q.most(2) * a * a + 4.0 * q.most(2) * v * j;
  Rates result{share * third + error.first * v, share * fourth + error.second * square + error.first * a, 0.0};
  if (!in.smooth) return result;
  const double fifth = q.most(5) * square * square * v + 10.0 * q.most(4) * square * v * a +
                       15.0 * q.most(3) * v * a * a + 10.0 * q.most(3) * square * j + 10.0 * q.most(2) * a * j;
  result.jerk = share * fifth + error.third * square * v + 3.0 * error.second * v * a + error.first * j;
  return result;
}

void SpanCheck::judge(const Ends& ends, const Rates& limits, bool smooth, std::uint8_t axis, Result& result) noexcept {
  const auto compare = [&](double first, double last, double more, double most) {
    const double share = (std::max(first, last) + more) / most;
    result.kept = result.kept && share <= 1.0;
    return std::pair{share, std::min(first, last) / most};
  };
  const auto exceeded = [&](double stretch) {
    if (stretch > result.stretch) result.stretch = stretch, result.axis = axis;
  };
  exceeded(compare(ends.first.speed, ends.last.speed, ends.more.speed, limits.speed).second);
  exceeded(std::sqrt(compare(ends.first.accel, ends.last.accel, ends.more.accel, limits.accel).second));
  if (!smooth) return;
  const auto [share, least] = compare(ends.first.jerk, ends.last.jerk, ends.more.jerk, limits.jerk);
  result.jerk_share = std::max(result.jerk_share, share);
  exceeded(std::sqrt(least));
}

void SpanCheck::check_joint(const PathSpan& span, std::size_t axis, double joint_accel, const Interval& in,
                            Result& result) const noexcept {
  const SpanCurve& q = span.curves[axis];
  const double from = in.first.s - span.from, to = in.last.s - span.from;
  const auto sizes = [](const Rates& r) { return Rates{std::fabs(r.speed), std::fabs(r.accel), std::fabs(r.jerk)}; };
  const Ends ends{sizes(rates(q.at(from), in.first)), sizes(rates(q.at(to), in.last)), most_between(span, axis, in)};
  judge(ends, {speed_[axis], joint_accel * accel_[axis], jerk_[axis]}, in.smooth, static_cast<std::uint8_t>(axis + 1),
        result);
  const double way = 0.5 * in.duration_s * (std::max(ends.first.speed, ends.last.speed) + ends.more.speed);
  const double a = q.value(from), b = q.value(to);
  const bool inside = std::min(a, b) - way >= lowest_rad_[axis] && std::max(a, b) + way <= highest_rad_[axis];
  result.kept = result.kept && inside;
}

void SpanCheck::check_tool(const PathLimits& limits, const PathSpan& span, const Interval& in,
                           Result& result) noexcept {
  const auto check = [&](std::size_t curve, const Rates& most) {
    // Squares first.
    Ends ends;
    const auto add = [](Rates& sum, const Rates& r) {
      sum = {sum.speed + r.speed * r.speed, sum.accel + r.accel * r.accel, sum.jerk + r.jerk * r.jerk};
    };
    for (std::size_t i = curve; i < curve + 3; ++i) {
      add(ends.first, rates(span.curves[i].at(in.first.s - span.from), in.first));
      add(ends.last, rates(span.curves[i].at(in.last.s - span.from), in.last));
      add(ends.more, most_between(span, i, in));
    }
    for (Rates* r : {&ends.first, &ends.last, &ends.more}) {
      *r = {std::sqrt(r->speed), std::sqrt(r->accel), std::sqrt(r->jerk)};
    }
    judge(ends, most, in.smooth, 0, result);
  };
  constexpr double kJerk = 1.0 + PathCheck::kJerkTolerance;
  check(SpanSample::kMove, {limits.speed_mm_s, limits.accel_mm_s2, kJerk * limits.jerk_mm_s3});
  check(SpanSample::kTurn, {limits.turn_speed_rad_s, limits.turn_accel_rad_s2, kJerk * limits.turn_jerk_rad_s3});
}

// On a line or an arc the sizes of the derivatives of position and rotation are the same everywhere.
void SpanCheck::check_exact_tool(const CartesianSegment& segment, const Interval& in, Result& result) noexcept {
  const PathDirection direction = direction_at(segment, 0.0);
  const double move = direction.move.norm(), turn = direction.turn_per_mm.norm();
  const double bend = bend_at(segment, 0.0).norm(), jolt = move > 0.0 ? bend * bend / move : 0.0;
  const auto of_move = [&](double v, double a, double j) {
    return Rates{move * v, math::hypot(move * a, bend * v * v),
                 math::hypot(move * std::fabs(j) + jolt * v * v * v, 3.0 * bend * v * a)};
  };
  const auto of_turn = [&](double v, double a, double j) {
    return Rates{turn * v, turn * std::fabs(a), turn * std::fabs(j)};
  };
  // The largest speed and the largest acceleration need not be at the same time, but each is at one end, or the law
  // turns round between them.
  const auto ends = [&](const auto& of) {
    const Rates first = of(in.first.speed, in.first.accel, in.first.jerk);
    const Rates last = of(in.last.speed, in.last.accel, in.last.jerk);
    const Rates most = of(in.speed, in.accel, in.jerk);
    const Rates more{most.speed - std::max(first.speed, last.speed), most.accel - std::max(first.accel, last.accel),
                     most.jerk - std::max(first.jerk, last.jerk)};
    return Ends{first, last, more};
  };
  const PathLimits& most = segment.limits;
  constexpr double kSpeed = 1.0 + PathCheck::kSpeedTolerance, kAccel = 1.0 + PathCheck::kToolTolerance;
  constexpr double kJerk = 1.0 + PathCheck::kJerkTolerance;
  judge(ends(of_move), {kSpeed * most.speed_mm_s, kAccel * most.accel_mm_s2, kJerk * most.jerk_mm_s3}, in.smooth, 0,
        result);
  judge(ends(of_turn), {kSpeed * most.turn_speed_rad_s, kAccel * most.turn_accel_rad_s2, kJerk * most.turn_jerk_rad_s3},
        in.smooth, 0, result);
}

SpanCheck::Result SpanCheck::check(const CartesianSegment& segment, const PathSpan& span, const SpanMotion& from,
                                   double duration_s) const noexcept {
  Interval in{.first = from,
              .last = from.after(duration_s),
              .duration_s = duration_s,
              .jerk = std::fabs(from.jerk),
              .smooth = segment.profile == ProfileKind::kSCurve};
  in.speed = std::max(in.first.speed, in.last.speed) + in.jerk * duration_s * duration_s / 8.0;
  in.accel = std::max(std::fabs(in.first.accel), std::fabs(in.last.accel));
  Result result{.kept = true};
  if (span.exact_tool) {
    check_exact_tool(segment, in, result);
  } else {
    check_tool(segment.limits, span, in, result);
  }
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    check_joint(span, axis, segment.limits.joint_accel, in, result);
  }
  return result;
}

bool SpanCheck::joins(const CartesianSegment& segment, const PathSpan& span, const SpanMotion& before,
                      const SpanMotion& behind) const noexcept {
  constexpr double kTick = kTickSeconds;
  const double way = std::fabs(behind.s - before.s), speed = std::fabs(behind.speed - before.speed);
  const double accel = std::fabs(behind.accel - before.accel);
  const bool smooth = segment.profile == ProfileKind::kSCurve;
  const double change = way / math::square(kTick) + speed / kTick;
  return all_curves(segment, [&](std::size_t curve, double most_accel, double most_jerk) {
    const double slope = span.curves[curve].most(1);
    if (!(slope * change <= kJoin * most_accel)) return false;
    return !smooth || slope * (accel + 2.0 * change) <= kJoinOfJerk * most_jerk * kTick;
  });
}

}  // namespace armature
