#include "controller/trajectory/cartesian/jerk_share.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "controller/base/timebase.hpp"

namespace armature {
namespace {

constexpr double kUnitsOfUse = 200.0;  // CartesianSegment::jerk_use: 1 is this number

// Whether [from, to] has a part of [begin, begin + length], times in s.
bool overlap(double from, double to, double begin, double length) {
  return length > 0.0 && from <= begin + length && begin <= to;
}

// An S-curve has its jerk in four parts.
double peak_jerk(const SCurveProfile& law, double from_s, double to_s) {
  if (law.shape == ProfileShape::kNone) return 0.0;
  const double second_s = law.jerk_s + law.hold_s, third_s = second_s + law.jerk_s + law.cruise_s;
  for (const double begin_s : {0.0, second_s, third_s, third_s + second_s}) {
    if (overlap(from_s, to_s, begin_s, law.jerk_s)) return law.jerk;
  }
  return 0.0;
}

// The parts of a segment that contain [from, to], ticks of the plan.
struct Parts {
  std::size_t first, last;
};
Parts parts(const CartesianSegment& segment, double from, double to) {
  constexpr auto kParts = static_cast<double>(CartesianSegment::kParts);
  const auto start = static_cast<double>(segment.start.value()), ticks = static_cast<double>(segment.duration.value());
  const auto part = [&](double at) {
    return static_cast<std::size_t>(std::clamp((at - start) / ticks * kParts, 0.0, kParts - 1.0));
  };
  return {part(from), part(to)};
}

// Calls visit(segment, parts) for the segments that are active in [from, to].
template <class Plan, class Visit>
void each_part(Plan& plan, double from, double to, Visit visit) {
  for (std::size_t i = segment_at(plan, to * kTickSeconds) + 1; i-- > 0;) {
    auto& segment = plan.segments[i];
    if (static_cast<double>(end_of(segment).value()) < from) return;
    if (segment.duration > Ticks{0}) visit(segment, parts(segment, from, to));
  }
}

}  // namespace

double jerk_share(const JointPlan& plan, const RobotModel& robot, double from, double to) noexcept {
  double most = 0.0;
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    const TimeLaw& law = plan.profiles[axis];
    if (law.kind != ProfileKind::kSCurve) continue;
    const double jerk = peak_jerk(law.scurve, from * kTickSeconds, to * kTickSeconds);
    most = std::max(most, jerk / robot.axes[axis].max_jerk_rad_s3);
  }
  return most;
}

double jerk_share(const RetargetPlan& plan, const RobotModel& robot, double from, double to) noexcept {
  double most = 0.0;
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    const std::span<const PhaseLaw::Knot> knots = plan.laws[axis].knots();
    for (std::size_t i = knots.size(); i-- > 0;) {
      if (knots[i].start_s > to * kTickSeconds) continue;
      most = std::max(most, std::fabs(knots[i].jerk) / robot.axes[axis].max_jerk_rad_s3);
      if (knots[i].start_s <= from * kTickSeconds) break;
    }
  }
  return most;
}

double jerk_share(const CartesianPlan& plan, double from, double to) noexcept {
  std::uint8_t most = 0;
  each_part(plan, from, to, [&](const CartesianSegment& segment, const Parts& parts) {
    for (std::size_t i = parts.first; i <= parts.last; ++i) most = std::max(most, segment.jerk_use[i]);
  });
  return most / kUnitsOfUse;
}

bool limits_jerk(const JointPlan& plan) noexcept {
  return std::any_of(plan.profiles.begin(), plan.profiles.end(),
                     [](const TimeLaw& law) { return law.kind == ProfileKind::kSCurve && law.peak_speed() > 0.0; });
}

PlanRun run_at(const CartesianPlan& plan, double ticks) noexcept {
  PlanRun run;
  std::int64_t end = 0;
  for (std::size_t i = 0; i < plan.count; ++i) {
    const CartesianSegment& segment = plan.segments[i];
    if (segment.start.value() >= end) {  // the tool rests
      if (i > 0 && ticks < run.end_ticks) break;
      run = {};
    }
    run.limits_jerk = run.limits_jerk || segment.profile == ProfileKind::kSCurve;
    end = std::max(end, end_of(segment).value());
    run.end_ticks = static_cast<double>(end);
  }
  return run;
}

void clear_jerk_use(CartesianPlan& plan) noexcept {
  for (std::size_t i = plan.known; i < plan.count; ++i) plan.segments[i].jerk_use.fill(0);
}

void add_jerk_use(CartesianPlan& plan, double from, double to, double share) noexcept {
  if (share == 0.0) return;
  const auto use = static_cast<std::uint8_t>(std::min(share * kUnitsOfUse + 1.0, 255.0));
  each_part(plan, from, to, [&](CartesianSegment& segment, const Parts& parts) {
    for (std::size_t i = parts.first; i <= parts.last; ++i) segment.jerk_use[i] = std::max(segment.jerk_use[i], use);
  });
}

}  // namespace armature
