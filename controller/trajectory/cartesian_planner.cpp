#include "controller/trajectory/cartesian_planner.hpp"

#include <algorithm>

#include "controller/core/timebase.hpp"
#include "controller/trajectory/blend.hpp"
#include "controller/trajectory/five_axis_turning.hpp"
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
    : arm_{arm}, plane_{robot.arm, flange_T_tool}, max_stretch_{max_stretch}, check_{robot} {}

void CartesianPlanner::begin(const JointAngles& start, std::span<const SegmentRequest> chain) noexcept {
  problem_ = {};
  passes_ = 0;
  progress_ = Progress::kWorking;
  rounded_ = has_rounded_plan_ = false;
  if (!lay_out(start, chain)) return;
  choose_corners();
  if (schedule()) begin_pass();
}

void CartesianPlanner::give_up() noexcept {
  progress_ = Progress::kIdle;
}

CartesianPlanner::Progress CartesianPlanner::work(std::size_t samples) noexcept {
  for (; samples > 0 && progress_ == Progress::kWorking; --samples) step();
  return progress_;
}

// Geometry.
bool CartesianPlanner::lay_out(const JointAngles& start, std::span<const SegmentRequest> chain) noexcept {
  if (chain.size() > CartesianPlan::kMostSegments) {
    refuse(PathProblem::Kind::kTooManySegments, CartesianPlan::kMostSegments);
    return false;
  }
  plan_.start = plan_.target = start;
  plan_.tool_T_flange = inverse(plane_.flange_T_tool());
  plan_.count = chain.size();
  Transform from = arm_.forward(start) * plane_.flange_T_tool();
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
    segment.tag = request.tag;
    if (!lay_out_orientation(i, from, request)) return false;
    limits_[i] = segment.limits = request.limits;
    profile_[i] = request.profile;
    blend_mm_[i] = i + 1 < chain.size() ? request.blend_mm : 0.0;
  }
  return true;
}

// `from` becomes the end of the segment.
bool CartesianPlanner::lay_out_orientation(std::size_t segment, Transform& from,
                                           const SegmentRequest& request) noexcept {
  const Transform to{request.target.rotation, plan_.segments[segment].path.end_mm};
  if (!plane_.exists()) {
    plan_.segments[segment].orientation = turn(from.rotation, to.rotation);
    from = to;
    return true;
  }
  const TurningEnd end = lay_out_turning(plan_.segments[segment], plane_, from, to, request.keeps_orientation);
  if (!(end.residual_rad <= plane_.max_residual_rad())) {
    refuse(PathProblem::Kind::kOrientation, segment);
    problem_.at = 1.0;
    problem_.residual_rad = end.residual_rad;
    return false;
  }
  from = end.base_T_tool;
  return true;
}

// Corner by corner, from the first one: rounded where the two segments then take less time together.
void CartesianPlanner::choose_corners() noexcept {
  passes_of_plan_ = 0;
  rounded_ = false;
  least_exact_ = {};
  corner_.fill({});
  stretch_.fill(1.0);
  for (std::size_t i = 0; i < plan_.count; ++i) {
    plan_law(i);
    if (plan_.segments[i].duration > kLongestMove) return;  // schedule() refuses it
    least_exact_ += plan_.segments[i].duration;
  }
  for (std::size_t i = 0; i + 1 < plan_.count; ++i) {
    const auto may_round = [&](std::size_t corner) {
      return blend_mm_[corner] > 0.0 && corner + 1 < plan_.count && has_length(plan_.segments[corner]) &&
             has_length(plan_.segments[corner + 1]);
    };
    if (!may_round(i)) continue;
    const Ticks exact = time_of_pair(i);
    const double most_of_first = i > 0 && may_round(i - 1) ? 1.0 / 3.0 : 0.5;
    const double most_of_second = may_round(i + 1) ? 1.0 / 3.0 : 0.5;
    corner_[i] = rounded_corner({plan_.segments[i], limits_[i], most_of_first},
                                {plan_.segments[i + 1], limits_[i + 1], most_of_second}, blend_mm_[i]);
    plan_law(i);
    plan_law(i + 1);
    if (time_of_pair(i) < exact) {
      rounded_ = true;
    } else {
      corner_[i] = {};
      plan_law(i);
      plan_law(i + 1);
    }
  }
}

// The fastest law between the corners of a segment, in whole ticks already: to stretch a thousandth of a tick would
// not make it slower.
void CartesianPlanner::plan_law(std::size_t index) noexcept {
  CartesianSegment& segment = plan_.segments[index];
  const TimeLaw law =
      fastest_law(profile_[index], segment, limits_[index], index > 0 ? corner_[index - 1] : Corner{}, corner_[index]);
  segment.duration = whole_ticks(law.duration_s());
  fastest_[index] = scale_in_time(law, seconds(segment.duration.value()));
  segment.law = fastest_[index];
}

// Of two neighbours, without what they share with each other and with the one before.
Ticks CartesianPlanner::time_of_pair(std::size_t first) const noexcept {
  const CartesianSegment &a = plan_.segments[first], &b = plan_.segments[first + 1];
  if (a.duration > kLongestMove || b.duration > kLongestMove) return kLongestMove + kLongestMove;
  Ticks result = a.duration + b.duration - overlap(a, b, corner_[first].blend_mm);
  if (first > 0) result -= overlap(plan_.segments[first - 1], a, corner_[first - 1].blend_mm);
  return result;
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
    const Ticks early = i > 0 ? overlap(plan_.segments[i - 1], segment, corner_[i - 1].blend_mm) : Ticks{0};
    segment.start = Ticks{end} - early;
    end = (segment.start + segment.duration).value();
    if (end > kLongestMove.value()) {
      refuse(PathProblem::Kind::kTooLong, i);
      return false;
    }
  }
  plan_.duration = Ticks{end};
  if (has_rounded_plan_ && rounded_plan_.duration <= plan_.duration) {
    accept();
    return false;
  }
  return true;
}

void CartesianPlanner::accept() noexcept {
  if (has_rounded_plan_ && rounded_plan_.duration <= plan_.duration) plan_ = rounded_plan_;
  progress_ = Progress::kDone;
}

void CartesianPlanner::begin_with_exact_stops() noexcept {
  progress_ = Progress::kWorking;
  blend_mm_.fill(0.0);
  choose_corners();
  if (schedule()) begin_pass();
}

// A chain with exact stops may do where one with rounded corners does not, and the other way round.
void CartesianPlanner::end_refused(bool because_of_corners) noexcept {
  if (has_rounded_plan_) {
    plan_ = rounded_plan_;
    problem_ = {};
    progress_ = Progress::kDone;
  } else if (rounded_ && because_of_corners) {
    problem_ = {};
    begin_with_exact_stops();
  } else {
    progress_ = Progress::kRefused;
  }
}

void CartesianPlanner::begin_pass() noexcept {
  tick_ = 0;
  failed_until_ = 0;
  joints_ = plan_.start;
  if (plan_.duration == Ticks{0}) {
    progress_ = Progress::kDone;
    return;
  }
  check_.begin(joints_, tool_sample(plan_, 0.0));
}

void CartesianPlanner::step() noexcept {
  ++tick_;
  const ToolSample sample = tool_sample(plan_, seconds(tick_));
  const bool beside = sample.tool.missing_mm > 0.0;
  const FollowedTool followed =
      beside ? FollowedTool{{.status = IkStatus::kUnreachable, .margin_mm = sample.tool.missing_mm}, false}
             : follow_tool(plan_, arm_, seconds(tick_), joints_);
  const IkTracking& tracking = followed.tracking;
  if (!solved(tracking.status)) {
    note_failure(tracking);
  } else if (failed_until_ == 0) {
    joints_ = tracking.joints;
    double& residual_rad = plan_.segments[segment_of(plan_, tick_)].residual_rad;
    residual_rad = std::max(residual_rad, tracking.residual_rad);
    check_.add(plan_, limits_, joints_, sample, followed.through_wrist);
    if (check_.axis_at_its_limit() != 0) {
      note_failure({.joints = joints_, .status = IkStatus::kOutsideLimits, .axis = check_.axis_at_its_limit()});
    }
  }
  if (failed_until_ != 0) {
    if (tick_ >= failed_until_) end_refused(failed_in_corner_);
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
  failed_in_corner_ = index + 1 < plan_.count && plan_.segments[index + 1].start.value() <= tick_;
  if (index > 0) {
    const CartesianSegment& before = plan_.segments[index - 1];
    failed_in_corner_ = failed_in_corner_ || tick_ < (before.start + before.duration).value();
  }
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
  ++passes_of_plan_;
  check_.finish(plan_, limits_);
  const PathCheck::PerSegment excess = check_.excess(plan_);
  const double more = 1.0 + 0.001 * static_cast<double>(std::int64_t{1} << (passes_of_plan_ - 1));
  std::size_t worst = 0;
  for (std::size_t i = 0; i < plan_.count; ++i) {
    if (excess[i].stretch > 1.0) stretch_[i] *= excess[i].stretch * more;
    if (excess[i].stretch > excess[worst].stretch) worst = i;
  }
  if (excess[worst].stretch == 1.0) {
    plan_.target = joints_;
    if (rounded_ && plan_.duration > least_exact_) {
      rounded_plan_ = plan_;
      has_rounded_plan_ = true;
      begin_with_exact_stops();
    } else {
      accept();
    }
    return;
  }
  const auto slowest = static_cast<std::size_t>(
      std::max_element(stretch_.begin(), stretch_.begin() + static_cast<std::ptrdiff_t>(plan_.count)) -
      stretch_.begin());
  if (!(stretch_[slowest] <= max_stretch_)) {
    refuse_as_too_fast(slowest, excess[slowest]);
  } else if (passes_of_plan_ == kMostPasses) {
    refuse_as_too_fast(worst, excess[worst]);
  } else if (schedule()) {
    begin_pass();
  }
}

void CartesianPlanner::refuse_as_too_fast(std::size_t segment, const PathCheck::Excess& excess) noexcept {
  problem_.at = share_at(plan_.segments[segment], seconds(excess.tick.value()));
  problem_.axis = excess.axis;
  problem_.stretch = stretch_[segment];
  problem_.singular = nearest_singularity(arm_.manipulability(excess.joints));
  refuse(PathProblem::Kind::kTooFast, segment);
}

void CartesianPlanner::refuse(PathProblem::Kind kind, std::size_t segment) noexcept {
  problem_.kind = kind;
  problem_.segment = static_cast<std::uint8_t>(segment);
  end_refused(true);
}

}  // namespace armature
