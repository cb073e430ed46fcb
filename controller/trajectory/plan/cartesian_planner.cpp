#include "controller/trajectory/plan/cartesian_planner.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/cartesian/configuration_check.hpp"
#include "controller/trajectory/cartesian/jerk_share.hpp"
#include "controller/trajectory/cartesian/path_corners.hpp"
#include "controller/trajectory/cartesian/path_layout.hpp"
#include "controller/trajectory/plan/path_reach.hpp"
#include "controller/trajectory/plan/rate_bend.hpp"

namespace armature {
namespace {

constexpr double kSimilar = 0.002;  // of two excesses

// A bound of the first segment that takes too long at the limits of its tool; nothing if there is none.
std::optional<std::size_t> too_long(const CartesianPlan& plan) {
  for (std::size_t i = 0; i < plan.count; ++i) {
    const CartesianSegment& segment = plan.segments[i];
    const double least_s = std::max(segment.path.length_mm / segment.limits.speed_mm_s,
                                    turn_angle_rad(segment) / segment.limits.turn_speed_rad_s);
    if (least_s > seconds(kLongestSegment)) return i;
  }
  return std::nullopt;
}

bool rounded(const CartesianPlan& plan) {
  const auto has_corner = [](const CartesianSegment& segment) { return segment.corner > 0.0; };
  return std::any_of(plan.segments.begin(), plan.segments.begin() + static_cast<std::ptrdiff_t>(plan.count),
                     has_corner);
}

}  // namespace

CartesianPlanner::CartesianPlanner(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool,
                                   double max_stretch) noexcept
    : arm_{arm},
      plane_{robot.arm, flange_T_tool},
      max_stretch_{max_stretch},
      law_{robot, arm},
      bends_{arm},
      pass_{robot, arm} {}

void CartesianPlanner::begin(const JointAngles& start, std::span<const SegmentRequest> chain,
                             bool after_unasked_stop) noexcept {
  progress_ = Progress::kWorking;
  chain_ = chain;
  passes_ = 0;
  inverses_ = 0;
  first_work_ = {};
  planning_law_ = false;
  constexpr std::size_t kMax = CartesianPlan::kMaxFirstSegments;
  problem_ = lay_out_path(plan_, plane_, start, arm_.forward(start) * plane_.flange_T_tool(), chain);
  plan_.after_unasked_stop = after_unasked_stop;
  if (chain.size() > kMax) problem_ = {.kind = PathProblem::Kind::kTooManySegments, .segment = kMax};
  if (problem_.kind == PathProblem::Kind::kNone) {
    lay_out_corners(plan_, chain, true);
  }
  if (problem_.kind == PathProblem::Kind::kNone) problem_ = find_unreachable(plan_, arm_, chain);
  if (problem_.kind != PathProblem::Kind::kNone) {
    progress_ = Progress::kRefused;
    return;
  }
  outputs_.begin(chain);
  if (const std::optional<std::size_t> segment = too_long(plan_)) {
    refuse({.kind = PathProblem::Kind::kTooLong, .segment = static_cast<std::uint8_t>(*segment)}, false);
  } else if (!(length_of(plan_) > 0.0)) {
    const PathProblem other = find_other_configuration(plan_, arm_, plan_.start, Ticks{0});
    if (other.kind != PathProblem::Kind::kNone) return refuse(other, false);
    finish();
  } else {
    begin_chain();
  }
}

void CartesianPlanner::cancel() noexcept {
  progress_ = Progress::kIdle;
}

CartesianPlanner::Progress CartesianPlanner::work(std::int64_t inverses) noexcept {
  const std::int64_t until = inverses_ + inverses;
  while (inverses_ < until && progress_ == Progress::kWorking) {
    if (bends_stage_ == Bends::kLayingOut) {
      lay_out_bends();
      continue;
    }
    if (planning_law_) {
      plan_law();
      continue;
    }
    const PathPass::Progress progress = pass_.step(plan_);
    if (passes_ == 0) first_work_.pass += std::max(pass_.inverses(), 1);
    inverses_ += std::max(pass_.inverses(), 1);  // at least 1, so that the loop ends
    if (pass_.latest().stretch > 1.0) lower(pass_.latest());
    switch (progress) {
      case PathPass::Progress::kWorking:
        break;
      case PathPass::Progress::kDone:
        end_pass();
        break;
      case PathPass::Progress::kFailed:
        refuse(pass_.problem(), pass_.failed_in_corner());
        break;
    }
  }
  return progress_;
}

void CartesianPlanner::begin_chain() noexcept {
  passes_of_chain_ = 0;
  plan_.bends.count = 0;
  bends_stage_ = Bends::kNotConsidered;
  planning_law_ = true;
  law_.begin(plan_);
}

void CartesianPlanner::plan_law() noexcept {
  const ChainLaw::Progress progress = law_.step(plan_);
  if (passes_ == 0) first_work_.law += law_.inverses();
  inverses_ += law_.inverses();
  if (progress == ChainLaw::Progress::kDone) return end_law();
  if (progress == ChainLaw::Progress::kTooLate) return refuse({}, false);
  if (progress != ChainLaw::Progress::kSampled || bends_stage_ != Bends::kNotConsidered) return;
  bends_stage_ = Bends::kDone;
  if (!BendLayout::may_need(plan_, law_.least_wrist())) return;
  bends_stage_ = Bends::kLayingOut;
  bends_.begin(plan_);
}

void CartesianPlanner::lay_out_bends() noexcept {
  const BendLayout::Progress progress = bends_.step(plan_);
  inverses_ += std::max(bends_.inverses(), 1);
  if (progress == BendLayout::Progress::kWorking) return;
  bends_stage_ = Bends::kDone;
  if (plan_.bends.count > 0) law_.begin(plan_);
}

void CartesianPlanner::end_law() noexcept {
  planning_law_ = false;
  for (std::size_t i = 0; i < plan_.count; ++i) {
    CartesianSegment& segment = plan_.segments[i];
    const bool too_long = segment.duration > kLongestSegment;
    if (too_long && segment.stretch <= max_stretch_) {
      return refuse({.kind = PathProblem::Kind::kTooLong, .segment = static_cast<std::uint8_t>(i)}, true);
    }
    if (segment.stretch == 1.0) continue;
    const ChainLaw::Bottleneck bottleneck = law_.bottleneck(plan_, i);
    segment.stretched_for = bottleneck.axis;
    const bool refuses = segment.at_singularity == AtSingularity::kRefuse;
    if (segment.stretch <= max_stretch_ && !refuses) continue;
    const std::uint8_t singular = singularity_at(bottleneck.s);
    if (segment.stretch <= max_stretch_ && singular == kNotSingular) continue;
    const double at = segment.length > 0.0 ? (bottleneck.s - segment.from) / segment.length : 1.0;
    return refuse_as_too_fast(i, at, bottleneck.axis, singular, segment.stretch);
  }
  worst_ = lowered_ = {};
  pass_.begin(plan_);
}

void CartesianPlanner::lower(const PathCheck::Place& place) noexcept {
  if (place.stretch > worst_.stretch) worst_ = place;
  // Successive excesses of about the same size are one.
  const bool similar = std::fabs(place.stretch - lowered_.stretch) <= kSimilar + 0.3 * (lowered_.stretch - 1.0);
  if (lowered_.stretch > 1.0 && similar && place.from_tick <= lowered_.to_tick + 1.0) {
    lowered_.stretch = std::max(lowered_.stretch, place.stretch);
    lowered_.from_tick = std::min(lowered_.from_tick, place.from_tick);
    lowered_.to_tick = std::max(lowered_.to_tick, place.to_tick);
    return;
  }
  lower_pending();
  lowered_ = place;
}

void CartesianPlanner::lower_pending() noexcept {
  if (lowered_.stretch > 1.0) law_.lower(plan_, lowered_, 1.0 / margin());
  lowered_ = {};
}

// A margin, so that the passes end.
double CartesianPlanner::margin() const noexcept {
  const double first = plan_.continues && law_.smooth() ? 0.01 : 0.002;  // a window has less time for passes
  return 1.0 + first * static_cast<double>(std::int64_t{1} << passes_of_chain_);
}

void CartesianPlanner::end_pass() noexcept {
  lower_pending();
  ++passes_;
  ++passes_of_chain_;
  if (!(worst_.stretch > 1.0)) {
    plan_.target = pass_.joints();
    finish();
  } else if (passes_of_chain_ == kMaxPasses) {
    const double t_s = worst_.to_tick * kTickSeconds;
    const std::size_t segment = segment_at(plan_, t_s);
    refuse_as_too_fast(segment, share_at(plan_, segment, t_s), worst_.axis, singularity_at(plan_.table.position(t_s)),
                       worst_.stretch);
  } else {
    law_.plan_again();
    planning_law_ = true;
  }
}

void CartesianPlanner::finish() noexcept {
  progress_ = Progress::kDone;
  if (plan_.continues) {
    const PlanRun whole{.end_ticks = static_cast<double>(plan_.duration.value())};
    plan_.first_run = law_.smooth() ? run_at(plan_, CartesianPlan::kLeastTicks) : whole;
  }
  const std::optional<std::size_t> outside = outputs_.place(plan_);
  if (!outside) return;
  problem_ = {.kind = PathProblem::Kind::kOutputOutside, .segment = static_cast<std::uint8_t>(*outside)};
  progress_ = Progress::kRefused;
}

std::uint8_t CartesianPlanner::singularity_at(double s) noexcept {
  inverses_ += ChainLaw::kJointSteps;
  return arm_.nearest_singularity(law_.joints_at(plan_, s), kNearSingular);
}

void CartesianPlanner::refuse_as_too_fast(std::size_t segment, double at, std::uint8_t axis, std::uint8_t singular,
                                          double stretch) noexcept {
  refuse({.kind = PathProblem::Kind::kTooFast,
          .segment = static_cast<std::uint8_t>(segment),
          .at = std::clamp(at, 0.0, 1.0),
          .axis = axis,
          .singular = singular,
          .stretch = stretch},
         true);
}

// A chain with exact stops may be possible where one with rounded corners is not.
void CartesianPlanner::refuse(const PathProblem& problem, bool because_of_corners) noexcept {
  if (!plan_.continues && because_of_corners && rounded(plan_)) {
    for (CartesianSegment& segment : plan_.segments) segment.corner = 0.0;
    return begin_chain();
  }
  problem_ = problem;
  progress_ = Progress::kRefused;
}

}  // namespace armature
