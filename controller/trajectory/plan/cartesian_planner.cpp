#include "controller/trajectory/plan/cartesian_planner.hpp"

#include <algorithm>
#include <optional>

#include "controller/core/timebase.hpp"
#include "controller/trajectory/plan/path_layout.hpp"
#include "controller/trajectory/plan/path_reach.hpp"

namespace armature {
namespace {

// The nearest singularity, if one is near.
std::uint8_t nearest_singularity(const Manipulability& m) {
  const double nearest = std::min({m.shoulder, m.elbow, m.wrist});
  if (!(nearest < CartesianPlanner::kNearSingular)) return kNotSingular;
  return m.wrist == nearest ? kWristSingular : m.elbow == nearest ? kElbowSingular : kShoulderSingular;
}

}  // namespace

CartesianPlanner::CartesianPlanner(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool,
                                   double max_stretch) noexcept
    : arm_{arm}, plane_{robot.arm, flange_T_tool}, max_stretch_{max_stretch}, pass_{robot, arm} {}

void CartesianPlanner::begin(const JointAngles& start, std::span<const SegmentRequest> chain) noexcept {
  progress_ = Progress::kWorking;
  passes_ = 0;
  inverses_ = 0;
  has_rounded_plan_ = false;
  problem_ = lay_out_path(plan_, plane_, start, arm_.forward(start) * plane_.flange_T_tool(), chain);
  if (problem_.kind == PathProblem::Kind::kNone) problem_ = find_unreachable(plan_, arm_, chain);
  if (problem_.kind != PathProblem::Kind::kNone) {
    progress_ = Progress::kRefused;
    return;
  }
  timing_.begin(chain);
  begin_chain();
}

void CartesianPlanner::cancel() noexcept {
  progress_ = Progress::kIdle;
}

CartesianPlanner::Progress CartesianPlanner::work(std::int64_t inverses) noexcept {
  const std::int64_t until = inverses_ + inverses;
  while (inverses_ < until && progress_ == Progress::kWorking) {
    const PathPass::Progress progress = pass_.step(plan_);
    inverses_ += std::max(pass_.inverses(), 1);  // at least 1, so that the loop ends
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
  timing_.choose_corners(plan_);
  begin_pass();
}

void CartesianPlanner::begin_pass() noexcept {
  if (const std::optional<std::size_t> too_long = timing_.schedule(plan_)) {
    refuse({.kind = PathProblem::Kind::kTooLong, .segment = static_cast<std::uint8_t>(*too_long)}, true);
  } else if (has_rounded_plan_ && rounded_plan_.duration <= plan_.duration) {
    accept();  // further passes only make exact stops slower
  } else if (plan_.duration == Ticks{0}) {
    progress_ = Progress::kDone;
  } else {
    pass_.begin(plan_);
  }
}

void CartesianPlanner::end_pass() noexcept {
  ++passes_;
  ++passes_of_chain_;
  const PathCheck::PerSegment excess = pass_.excess(plan_);
  std::size_t worst = 0;
  for (std::size_t i = 1; i < plan_.count; ++i) {
    if (excess[i].stretch > excess[worst].stretch) worst = i;
  }
  if (excess[worst].stretch > 1.0) return stretch(excess, worst);

  plan_.target = pass_.joints();
  if (timing_.rounded() && plan_.duration > timing_.least_exact()) {
    rounded_plan_ = plan_;
    has_rounded_plan_ = true;
    timing_.disable_blends();
    begin_chain();
  } else {
    accept();
  }
}

void CartesianPlanner::stretch(const PathCheck::PerSegment& excess, std::size_t worst) noexcept {
  const double more = 1.0 + 0.001 * static_cast<double>(std::int64_t{1} << (passes_of_chain_ - 1));
  std::size_t slowest = 0;
  for (std::size_t i = 0; i < plan_.count; ++i) {
    CartesianSegment& segment = plan_.segments[i];
    if (excess[i].stretch > 1.0) {
      if (excess[i].stretch > segment.stretch) segment.stretched_for = excess[i].axis;
      segment.stretch *= excess[i].stretch * more;
    }
    if (segment.stretch > plan_.segments[slowest].stretch) slowest = i;
  }
  if (!(plan_.segments[slowest].stretch <= max_stretch_)) {
    refuse_as_too_fast(slowest, excess[slowest]);
  } else if (passes_of_chain_ == kMaxPasses) {
    refuse_as_too_fast(worst, excess[worst]);
  } else {
    begin_pass();
  }
}

void CartesianPlanner::accept() noexcept {
  if (has_rounded_plan_ && rounded_plan_.duration <= plan_.duration) plan_ = rounded_plan_;
  progress_ = Progress::kDone;
}

void CartesianPlanner::refuse_as_too_fast(std::size_t segment, const PathCheck::Excess& excess) noexcept {
  refuse({.kind = PathProblem::Kind::kTooFast,
          .segment = static_cast<std::uint8_t>(segment),
          .at = share_at(plan_.segments[segment], seconds(excess.tick)),
          .axis = excess.axis,
          .singular = nearest_singularity(arm_.manipulability(excess.joints)),
          .stretch = plan_.segments[segment].stretch},
         true);
}

// A chain with exact stops may be possible where one with rounded corners is not, and the other way round.
void CartesianPlanner::refuse(const PathProblem& problem, bool because_of_corners) noexcept {
  if (has_rounded_plan_) {
    plan_ = rounded_plan_;
    progress_ = Progress::kDone;
  } else if (timing_.rounded() && because_of_corners) {
    timing_.disable_blends();
    begin_chain();
  } else {
    problem_ = problem;
    progress_ = Progress::kRefused;
  }
}

}  // namespace armature
