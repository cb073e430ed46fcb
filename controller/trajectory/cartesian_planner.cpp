#include "controller/trajectory/cartesian_planner.hpp"

#include <algorithm>

#include "controller/core/timebase.hpp"
#include "controller/trajectory/blend.hpp"
#include "controller/trajectory/joint_move.hpp"
#include "controller/trajectory/synchronise.hpp"

namespace armature {
namespace {

double seconds(std::int64_t ticks) {
  return static_cast<double>(ticks) * kTickSeconds;
}

// The segment whose set-point a tick > 0 is: at a corner the one that ends.
std::size_t segment_of(const CartesianPlan& plan, std::int64_t tick) {
  std::size_t index = plan.count - 1;
  while (index > 0 && plan.segments[index].start.value() >= tick) --index;
  return index;
}

// Written so that a NaN is none.
bool are_positive(const PathLimits& limits, ProfileKind profile) {
  const bool jerks = limits.jerk_mm_s3 > 0.0 && limits.turn_jerk_rad_s3 > 0.0;
  return limits.speed_mm_s > 0.0 && limits.accel_mm_s2 > 0.0 && limits.turn_speed_rad_s > 0.0 &&
         limits.turn_accel_rad_s2 > 0.0 && (jerks || profile == ProfileKind::kTrapezoid);
}

// The singularity that is nearest, when one is near.
std::uint8_t nearest_singularity(const Manipulability& m) {
  const double nearest = std::min({m.shoulder, m.elbow, m.wrist});
  if (!(nearest < CartesianPlanner::kNearSingular)) return kNotSingular;
  return m.wrist == nearest ? kWristSingular : m.elbow == nearest ? kElbowSingular : kShoulderSingular;
}

}  // namespace

CartesianPlanner::CartesianPlanner(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool,
                                   double max_stretch) noexcept
    : arm_{arm}, flange_T_tool_{flange_T_tool}, max_stretch_{max_stretch}, check_{robot} {}

void CartesianPlanner::begin(const JointAngles& start, std::span<const SegmentRequest> chain) noexcept {
  problem_ = {};
  passes_ = 0;
  progress_ = Progress::kWorking;
  if (lay_out(start, chain) && schedule()) begin_pass();
}

void CartesianPlanner::give_up() noexcept {
  progress_ = Progress::kIdle;
}

CartesianPlanner::Progress CartesianPlanner::work(std::size_t samples) noexcept {
  for (; samples > 0 && progress_ == Progress::kWorking; --samples) step();
  return progress_;
}

// Geometry, and the fastest time law of each segment by itself.
bool CartesianPlanner::lay_out(const JointAngles& start, std::span<const SegmentRequest> chain) noexcept {
  if (chain.size() > CartesianPlan::kMostSegments) {
    refuse(PathProblem::Kind::kTooManySegments, CartesianPlan::kMostSegments);
    return false;
  }
  plan_.start = plan_.target = start;
  plan_.tool_T_flange = inverse(flange_T_tool_);
  plan_.count = chain.size();
  Transform from = arm_.forward(start) * flange_T_tool_;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const SegmentRequest& request = chain[i];
    if (!are_positive(request.limits, request.profile)) {
      refuse(PathProblem::Kind::kInvalidLimits, i);
      return false;
    }
    if (!is_rigid(request.target)) {
      refuse(PathProblem::Kind::kInvalidPose, i);
      return false;
    }
    CartesianSegment& segment = plan_.segments[i];
    segment = {};
    const Eigen::Vector3d &via_mm = request.via_mm, &to_mm = request.target.position_mm;
    std::optional<PositionPath> path;
    switch (request.kind) {
      case SegmentRequest::Kind::kLine:
        path = line(from.position_mm, to_mm);
        break;
      case SegmentRequest::Kind::kArc:
        path = arc(from.position_mm, via_mm, to_mm);
        break;
      case SegmentRequest::Kind::kCircle:
        path = circle(from.position_mm, via_mm, to_mm);
        break;
    }
    if (!path) {
      refuse(PathProblem::Kind::kNoCircle, i);
      return false;
    }
    segment.path = *path;
    segment.orientation = turn(from.rotation, request.target.rotation);
    from = {request.target.rotation, path->end_mm};
    limits_[i] = request.limits;
    blend_mm_[i] = i + 1 < chain.size() ? request.blend_mm : 0.0;
    stretch_[i] = 1.0;
  }
  Easing before;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const CartesianSegment& segment = plan_.segments[i];
    const Easing after = blend_mm_[i] > 0.0 ? easing(segment, plan_.segments[i + 1], blend_mm_[i]) : Easing{};
    const double distance = is_empty(segment) ? 0.0 : 1.0;
    const TimeLawLimits limits =
        is_empty(segment) ? TimeLawLimits{} : law_limits(segment, limits_[i], strongest(before, after));
    const TimeLaw law = plan_time_law(chain[i].profile, distance, limits);
    // In whole ticks already: to stretch a thousandth of a tick would not make it slower.
    fastest_[i] = scale_in_time(law, seconds(whole_ticks(law.duration_s()).value()));
    before = after;
  }
  return true;
}

// Stretches the laws to whole ticks and puts the segments one after the other.
bool CartesianPlanner::schedule() noexcept {
  std::int64_t end = 0;
  for (std::size_t i = 0; i < plan_.count; ++i) {
    CartesianSegment& segment = plan_.segments[i];
    segment.stretch = stretch_[i];
    segment.duration = whole_ticks(fastest_[i].duration_s() * stretch_[i]);
    if (segment.duration > kLongestMove) {
      refuse(PathProblem::Kind::kTooLong, i);
      return false;
    }
    segment.law = scale_in_time(fastest_[i], seconds(segment.duration.value()));
    const Ticks early = i > 0 ? overlap(plan_.segments[i - 1], segment, blend_mm_[i - 1]) : Ticks{0};
    segment.start = Ticks{end} - early;
    end = (segment.start + segment.duration).value();
    if (end > kLongestMove.value()) {
      refuse(PathProblem::Kind::kTooLong, i);
      return false;
    }
  }
  plan_.duration = Ticks{end};
  return true;
}

void CartesianPlanner::begin_pass() noexcept {
  tick_ = 0;
  failed_until_ = 0;
  joints_ = plan_.start;
  if (plan_.duration == Ticks{0}) {
    progress_ = Progress::kDone;
    return;
  }
  check_.begin(joints_, tool_pose(plan_, 0.0));
}

void CartesianPlanner::step() noexcept {
  ++tick_;
  const Transform base_T_tool = tool_pose(plan_, seconds(tick_));
  const FollowedTool followed = follow_tool(plan_, arm_, seconds(tick_), joints_);
  const IkTracking& tracking = followed.tracking;
  if (!solved(tracking.status)) {
    note_failure(tracking);
  } else if (failed_until_ == 0) {
    joints_ = tracking.joints;
    check_.add(plan_, limits_, joints_, base_T_tool, followed.through_wrist);
    if (check_.axis_at_its_limit() != 0) {
      note_failure({.joints = joints_, .status = IkStatus::kOutsideLimits, .axis = check_.axis_at_its_limit()});
    }
  }
  if (failed_until_ != 0) {
    if (tick_ >= failed_until_) progress_ = Progress::kRefused;
  } else if (tick_ == plan_.duration.value()) {
    end_pass();
  }
}

void CartesianPlanner::note_failure(const IkTracking& tracking) noexcept {
  if (failed_until_ != 0) {
    if (problem_.kind == PathProblem::Kind::kUnreachable) {
      problem_.margin_mm = std::max(problem_.margin_mm, tracking.margin_mm);
    } else {
      problem_.residual_rad = std::max(problem_.residual_rad, tracking.residual_rad);
    }
    return;
  }
  const std::size_t index = segment_of(plan_, tick_);
  const CartesianSegment& segment = plan_.segments[index];
  problem_.segment = static_cast<std::uint8_t>(index);
  problem_.at = share_at(segment, seconds(tick_));
  problem_.axis = tracking.axis;
  problem_.margin_mm = tracking.margin_mm;
  problem_.residual_rad = tracking.residual_rad;
  // How far a segment leads out of the reach is known at its end only; which joint is outside, at once.
  failed_until_ = (segment.start + segment.duration).value();
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

void CartesianPlanner::end_pass() noexcept {
  ++passes_;
  check_.finish(plan_, limits_);
  const PathCheck::PerSegment excess = check_.excess(plan_);
  const double more = 1.0 + 0.001 * static_cast<double>(std::int64_t{1} << (passes_ - 1));
  std::size_t worst = 0;
  for (std::size_t i = 0; i < plan_.count; ++i) {
    if (excess[i].stretch > 1.0) stretch_[i] *= excess[i].stretch * more;
    if (excess[i].stretch > excess[worst].stretch) worst = i;
  }
  if (excess[worst].stretch == 1.0) {
    plan_.target = joints_;
    progress_ = Progress::kDone;
    return;
  }
  const auto slowest = static_cast<std::size_t>(
      std::max_element(stretch_.begin(), stretch_.begin() + static_cast<std::ptrdiff_t>(plan_.count)) -
      stretch_.begin());
  if (!(stretch_[slowest] <= max_stretch_)) {
    refuse_as_too_fast(slowest, excess[slowest]);
  } else if (passes_ == kMostPasses) {
    refuse_as_too_fast(worst, excess[worst]);
  } else if (schedule()) {
    begin_pass();
  }
}

void CartesianPlanner::refuse_as_too_fast(std::size_t segment, const PathCheck::Excess& excess) noexcept {
  refuse(PathProblem::Kind::kTooFast, segment);
  problem_.at = share_at(plan_.segments[segment], seconds(excess.tick.value()));
  problem_.axis = excess.axis;
  problem_.stretch = stretch_[segment];
  problem_.singular = nearest_singularity(arm_.manipulability(excess.joints));
}

void CartesianPlanner::refuse(PathProblem::Kind kind, std::size_t segment) noexcept {
  problem_.kind = kind;
  problem_.segment = static_cast<std::uint8_t>(segment);
  progress_ = Progress::kRefused;
}

}  // namespace armature
