#include "controller/trajectory/check/path_pass.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/cartesian/bend_layout.hpp"
#include "controller/trajectory/cartesian/configuration_check.hpp"
#include "controller/trajectory/cartesian/jerk_share.hpp"
#include "controller/trajectory/path/orientation_path.hpp"

namespace armature {
namespace {

// The segment of the set-point at a tick > 0: at a corner the one that ends.
std::size_t segment_of(const CartesianPlan& plan, std::int64_t tick) {
  std::size_t index = segment_at(plan, seconds(Ticks{tick}));
  while (index > 0 && plan.segments[index].start.value() >= tick) --index;
  return index;
}

}  // namespace

PathPass::PathPass(const RobotModel& robot, const Arm& arm) noexcept
    : arm_{arm}, check_{robot}, kinks_{arm}, bounds_{robot, arm} {}

void PathPass::begin(const CartesianPlan& plan) noexcept {
  tick_ = 0;
  until_ = 1;  // always: segments without a length end there
  no_differences_ = plan.continues ? kKnownTicks : -1;
  first_ = true;
  unknown_ = false;
  problem_ = {};
  failed_in_corner_ = false;
  failed_until_ = 0;
  joints_ = plan.start;
  check_.begin(joints_, tool_sample(plan, 0.0));
  kinks_.begin(plan);
  bounds_.begin(plan);
  trail_.begin(joints_);
  inverses_ = 0;
  latest_ = {};
}

PathPass::Progress PathPass::step(CartesianPlan& plan) noexcept {
  if (std::exchange(first_, false)) clear_jerk_use(plan);
  if (tick_ < until_) return check_set_point(plan);
  step_bounds(plan);
  return Progress::kWorking;
}

void PathPass::step_bounds(CartesianPlan& plan) noexcept {
  const double from = bounds_.ticks();
  if (std::exchange(unknown_, false)) bounds_.continue_from(joints_);
  const PathBounds::Found found = bounds_.step(plan);
  inverses_ = bounds_.inverses();
  latest_ = {};
  switch (found) {
    case PathBounds::Found::kSearching:
      return;
    case PathBounds::Found::kKept: {
      add_jerk_use(plan, from, bounds_.ticks(), bounds_.jerk_share());
      if (!bounds_.at_sample()) return;
      const SpanSample& sample = bounds_.sample();
      trail_.add_sample(bounds_.ticks(), sample.joints);
      double& residual_rad = plan.segments[segment_on_path(plan, sample.s)].residual_rad;
      residual_rad = std::max(residual_rad, sample.residual_rad);
      return;
    }
    case PathBounds::Found::kExceeded:
      if (!plan.continues || bounds_.excess().to_tick > static_cast<double>(kKnownTicks)) latest_ = bounds_.excess();
      return;
    case PathBounds::Found::kUnknown:
      return check_between(plan, from, bounds_.ticks());
    case PathBounds::Found::kEnd:
      return check_between(plan, from, static_cast<double>(plan.duration.value()));
  }
}

// The set-points around these times are checked next.
void PathPass::check_between(const CartesianPlan& plan, double from, double to) noexcept {
  until_ = std::min(static_cast<std::int64_t>(to) + 1 + kBehind, plan.duration.value());
  unknown_ = true;
  const std::int64_t first = static_cast<std::int64_t>(from) - kBefore;
  if (first <= tick_ + kFewest) return;
  std::int64_t inverses = 0;
  joints_ = joints_at(plan, first, inverses);
  inverses_ += static_cast<int>(inverses);
  tick_ = first;
  no_differences_ = std::max(no_differences_, first + kWithoutDifferences);
  check_.restart(tick_, joints_, tool_sample(plan, seconds(Ticks{tick_})));
  kinks_.skip_to(tick_);
}

JointAngles PathPass::joints_at(const CartesianPlan& plan, std::int64_t tick, std::int64_t& inverses) const noexcept {
  constexpr double kStride = 8.0, kMostSteps = 32.0;
  JointTrail::Place place = trail_.before(static_cast<double>(tick));
  const double way = static_cast<double>(tick) - place.ticks;
  const double strides = std::clamp(way / kStride, 1.0, kMostSteps);
  auto steps = static_cast<int>(strides);
  if (steps < strides) ++steps;
  for (int left = steps - 1; left >= 0; --left) {
    const double ticks = static_cast<double>(tick) - static_cast<double>(left) / steps * way;
    int computed = 0;
    place.joints = position(plan, arm_, ticks * kTickSeconds, place.joints, computed);
    inverses += computed;
  }
  return place.joints;
}

PathPass::Progress PathPass::check_set_point(CartesianPlan& plan) noexcept {
  ++tick_;
  // The plan before has been checked up to here, or the bounds have shown enough; differences are not known.
  const bool known = tick_ <= no_differences_;
  const double t_s = seconds(Ticks{tick_});
  ToolSample sample = tool_sample(plan, t_s);
  const bool beside = sample.tool.missing_mm > 0.0;
  const FollowedTool followed =
      beside ? FollowedTool{.tracking = {.status = IkStatus::kUnreachable, .margin_mm = sample.tool.missing_mm}}
             : follow_tool(plan, arm_, t_s, joints_);
  inverses_ = beside ? 0 : followed.inverses;
  IkTracking tracking = followed.tracking;
  if (followed.on_bend && solved(tracking.status)) check_bend(plan, tracking, sample);
  if (!solved(tracking.status)) {
    record_failure(plan, tracking);
  } else if (failed_until_ == 0) {
    joints_ = tracking.joints;
    double& residual_rad = plan.segments[segment_of(plan, tick_)].residual_rad;
    residual_rad = std::max(residual_rad, tracking.residual_rad);
    check_.add(plan, joints_, sample, followed.through_wrist);
    check_.add_tool_between(plan, sample_between(plan, t_s - 0.5 * kTickSeconds));
    if (!known) {
      const auto tick = static_cast<double>(tick_);
      add_jerk_use(plan, tick - 3.0, tick, check_.jerk_share());
    }
    inverses_ += kinks_.sample(plan, tick_, joints_, check_);
    if (check_.axis_at_its_limit() != 0) {
      record_failure(plan, {.joints = joints_, .status = IkStatus::kOutsideLimits, .axis = check_.axis_at_its_limit()});
    } else if (const PathProblem other = find_other_configuration(plan, arm_, joints_, Ticks{tick_});
               other.kind != PathProblem::Kind::kNone) {
      problem_ = other;
      failed_until_ = tick_;
    }
  }
  latest_ = check_.take_latest();
  if (known) latest_ = {};
  if (failed_until_ != 0) {
    until_ = failed_until_;
    return tick_ >= failed_until_ ? Progress::kFailed : Progress::kWorking;
  }
  trail_.add_tick(static_cast<double>(tick_), joints_);
  if (tick_ < plan.duration.value()) return Progress::kWorking;
  check_.finish(plan);
  if (const PathCheck::Place after = check_.take_latest(); after.stretch > latest_.stretch) latest_ = after;
  return Progress::kDone;
}

// On a bend the tool turns as the joints turn it.
void PathPass::check_bend(const CartesianPlan& plan, IkTracking& tracking, ToolSample& sample) const noexcept {
  const Transform held = held_tool_pose(plan, arm_, tracking.joints);
  const double off_mm = (held.position_mm - sample.tool.base_T_tool.position_mm).norm();
  tracking.residual_rad = turn(sample.rotation, held.rotation).angle_rad;
  sample.rotation = held.rotation;
  const CartesianSegment& segment = plan.segments[segment_of(plan, tick_)];
  if (!(tracking.residual_rad <= BendLayout::allowed_deviation(segment))) tracking.status = IkStatus::kOrientation;
  if (!(off_mm <= kPointTolerance_mm)) tracking.status = IkStatus::kInvalidInput;
}

// The tool between the last two set-points.
ToolSample PathPass::sample_between(const CartesianPlan& plan, double t_s) noexcept {
  ToolSample sample = tool_sample(plan, t_s);
  if (plan.bends.count == 0) return sample;
  const FollowedTool followed = follow_tool(plan, arm_, t_s, joints_);
  if (followed.on_bend) {
    inverses_ += followed.inverses;
    sample.rotation = held_tool_pose(plan, arm_, followed.tracking.joints).rotation;
  }
  return sample;
}

void PathPass::record_failure(const CartesianPlan& plan, const IkTracking& tracking) noexcept {
  if (failed_until_ != 0) {
    if (problem_.kind == PathProblem::Kind::kUnreachable) {
      problem_.margin_mm = std::max(problem_.margin_mm, tracking.margin_mm);
    } else {
      problem_.residual_rad = std::max(problem_.residual_rad, tracking.residual_rad);
    }
    return;
  }
  const std::size_t index = segment_of(plan, tick_);
  const CartesianSegment& segment = plan.segments[index];
  failed_in_corner_ = segment.corner > 0.0 || (index > 0 && plan.segments[index - 1].corner > 0.0);
  problem_.segment = static_cast<std::uint8_t>(index);
  problem_.at = share_at(plan, index, seconds(Ticks{tick_}));
  problem_.axis = tracking.axis;
  if (tracking.axis != 0) problem_.angle_rad = tracking.joints[tracking.axis - 1U].value();
  problem_.margin_mm = tracking.margin_mm;
  problem_.residual_rad = tracking.residual_rad;
  // How far a segment exceeds the reach is known only at its end; which joint is outside is known at once.
  failed_until_ = end_of(segment).value();
  if (tracking.status == IkStatus::kUnreachable) {
    problem_.kind = PathProblem::Kind::kUnreachable;
  } else if (tracking.status == IkStatus::kOrientation) {
    problem_.kind = PathProblem::Kind::kOrientation;
  } else {
    const bool outside = tracking.status == IkStatus::kOutsideLimits;
    problem_.kind = outside ? PathProblem::Kind::kOutsideLimits : PathProblem::Kind::kInvalidPose;
    failed_until_ = tick_;
  }
}

}  // namespace armature
