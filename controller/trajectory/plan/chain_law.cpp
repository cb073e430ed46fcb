#include "controller/trajectory/plan/chain_law.hpp"

#include <algorithm>
#include <cmath>

#include "controller/core/rounding.hpp"
#include "controller/core/timebase.hpp"
#include "controller/trajectory/plan/path_corners.hpp"

namespace armature {
namespace {

// The grids of both laws differ; a segment that takes longer by less counts as not slowed down.
constexpr double kNotSlower = 2e-3;
// Share of a limit from which on it counts as reached.
constexpr double kAtItsLimit = 0.98;

}  // namespace

void ChainLaw::begin(const CartesianPlan& plan) noexcept {
  stage_ = Stage::kToolGrid;
  smooth_ = false;
  grid_.begin(plan, law_, LawGrid::With::kToolOnly);
}

void ChainLaw::plan_again() noexcept {
  stage_ = smooth_ ? Stage::kSmooth : Stage::kLaw;
  smooth_ ? smooth_law_.plan_again(law_) : law_.begin();
}

ChainLaw::Progress ChainLaw::step(CartesianPlan& plan) noexcept {
  inverses_ = 1;
  switch (stage_) {
    case Stage::kToolGrid:
      if (grid_.step(plan, law_) == LawGrid::Progress::kWorking) break;
      law_.begin();
      stage_ = Stage::kToolLaw;
      break;
    case Stage::kToolLaw:
      inverses_ = kIntervals;
      if (law_.work(kIntervals) == SpeedLaw::Progress::kWorking) break;
      measure(plan, tool_s_);
      grid_.begin(plan, law_, LawGrid::With::kJoints);
      inverses_ += grid_.inverses();
      stage_ = Stage::kGrid;
      break;
    case Stage::kGrid: {
      const bool working = grid_.step(plan, law_) == LawGrid::Progress::kWorking;
      inverses_ = std::max(1, grid_.inverses());
      if (working) break;
      law_.begin();
      stage_ = Stage::kLaw;
      return Progress::kSampled;
    }
    case Stage::kLaw:
      inverses_ = kIntervals;
      if (law_.work(kIntervals) == SpeedLaw::Progress::kWorking) break;
      measure(plan, joint_s_);
      smooth_ = smooth_law_.begin(law_);
      stage_ = Stage::kSmooth;
      if (smooth_) break;
      finish(plan);
      stage_ = Stage::kDone;
      break;
    case Stage::kSmooth:
      inverses_ = kIntervals;
      if (smooth_law_.work(law_, kIntervals) == SmoothLaw::Progress::kWorking) break;
      finish(plan);
      stage_ = Stage::kDone;
      break;
    case Stage::kDone:
      break;
  }
  return stage_ == Stage::kDone ? Progress::kDone : Progress::kWorking;
}

void ChainLaw::measure(const CartesianPlan& plan,
                       std::array<double, CartesianPlan::kMaxSegments>& time_s) const noexcept {
  time_s.fill(0.0);
  std::size_t segment = 0;
  for (std::size_t i = 0; i + 1 < law_.size(); ++i) {
    const double step = law_.s(i + 1) - law_.s(i);
    if (!(step > 0.0)) continue;
    const double middle = law_.s(i) + 0.5 * step;
    while (segment + 1 < plan.count && middle > plan.segments[segment].from + plan.segments[segment].length) ++segment;
    time_s[segment] += law_.duration_s(i);
  }
}

void ChainLaw::finish(CartesianPlan& plan) noexcept {
  smooth_ ? smooth_law_.write(plan.table) : plan.table.assign(law_);
  plan.duration = plan.table.duration();
  for (std::size_t i = 0; i < plan.count; ++i) {
    CartesianSegment& segment = plan.segments[i];
    const double slower = tool_s_[i] > 0.0 ? joint_s_[i] / tool_s_[i] : 1.0;
    segment.stretch = slower > 1.0 + kNotSlower ? slower : 1.0;
    segment.stretched_for = 0;
    const double ticks = plan.table.time_at(segment.from) / kTickSeconds;
    if (i > 0 && joint_after(plan, i - 1) != PathJoint::kStop) {
      const auto end = static_cast<std::int64_t>(rounded_up(ticks));
      segment.start = Ticks{end - 1};
      plan.segments[i - 1].duration = Ticks{end} - plan.segments[i - 1].start;
      continue;
    }
    segment.start = Ticks{round_half_away(ticks)};
    if (i > 0) plan.segments[i - 1].duration = segment.start - plan.segments[i - 1].start;
  }
  CartesianSegment& last = plan.segments[plan.count - 1];
  last.duration = plan.duration - last.start;
  if (!smooth_) return;
  // The jerk of a joint may make a passage beside a singularity slower than its speed and acceleration by far.
  for (std::size_t i = 0; i < plan.count; ++i) {
    CartesianSegment& segment = plan.segments[i];
    if (segment.duration > kLongestSegment && tool_s_[i] > 0.0)
      segment.stretch = seconds(segment.duration) / tool_s_[i];
  }
}

void ChainLaw::lower(const CartesianPlan& plan, const PathCheck::Place& place, double share) noexcept {
  double from_s = place.from_tick * kTickSeconds, to_s = place.to_tick * kTickSeconds;
  if (smooth_) {
    // A moving average is that of the law around.
    const double half_s = 0.5 * smooth_law_.tau_s(plan.table.position(0.5 * (from_s + to_s)));
    from_s -= half_s;
    to_s += half_s;
  }
  law_.lower(plan.table.position(from_s), plan.table.position(to_s), share / place.stretch);
}

ChainLaw::Bottleneck ChainLaw::bottleneck(const CartesianPlan& plan, std::size_t segment) const noexcept {
  const CartesianSegment& path = plan.segments[segment];
  struct Load {
    double time_s = 0.0, slope = 0.0, s = 0.0;
  };
  PerAxis<Load> loads{};
  const double end = path.from + path.length;
  for (std::size_t i = law_.point_at(path.from); i + 1 < law_.size() && law_.s(i) < end; ++i) {
    if (!(law_.s(i + 1) > law_.s(i)) || law_.s(i) < path.from) continue;
    const double accel = law_.accel(i), time_s = law_.duration_s(i);
    for (const std::size_t point : {i, i + 1}) {
      const LawGrid::Busiest joint = grid_.busiest(law_.limits(point), law_.square(point), accel);
      if (joint.share < kAtItsLimit) continue;
      Load& load = loads[joint.axis];
      load.time_s += 0.5 * time_s;
      const double slope = std::fabs(law_.limits(point).bands[joint.axis].by_accel);
      if (slope > load.slope) load = {load.time_s, slope, law_.s(point)};
    }
  }
  Bottleneck result{.s = path.from};
  double longest_s = 0.0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (loads[axis].time_s <= longest_s) continue;
    longest_s = loads[axis].time_s;
    result = {.axis = static_cast<std::uint8_t>(axis + 1), .s = loads[axis].s};
  }
  return result;
}

JointAngles ChainLaw::joints_at(const CartesianPlan& plan, double s) const noexcept {
  JointAngles joints = plan.start;
  for (int step = 1; step <= kJointSteps; ++step) {
    const IkTracking tracking = joints_on_path(plan, arm_, s * step / kJointSteps, joints);
    if (tracking.found) joints = tracking.joints;
  }
  return joints;
}

}  // namespace armature
