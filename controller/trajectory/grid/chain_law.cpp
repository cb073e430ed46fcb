#include "controller/trajectory/grid/chain_law.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"

namespace armature {
namespace {

// Share of a limit from which on it counts as reached.
constexpr double kAtItsLimit = 0.98;
constexpr double kTimeRounding_s = 1e-9;

}  // namespace

void ChainLaw::begin(const CartesianPlan& plan) noexcept {
  stage_ = Stage::kToolGrid;
  smooth_ = false;
  rounds_ = SpeedLaw::kMaxRounds;
  grid_.begin(plan, law_, LawGrid::With::kToolOnly);
}

ChainLaw::LawMotion ChainLaw::motion(const CartesianPlan& plan) const noexcept {
  if (!smooth_) return {plan.table, 0.0};
  return {smooth_law_.table(), seconds(smooth_law_.later())};
}

double ChainLaw::tau_s() const noexcept {
  return smooth_ ? smooth_law_.tau_s(law_.s(law_.size() - 1)) : 0.0;
}

std::optional<ChainLaw::Joint> ChainLaw::joint_at(const CartesianPlan& plan, double earliest_s) noexcept {
  const LawMotion motion = this->motion(plan);
  double s = motion.table.position(earliest_s - motion.later_s);
  if (smooth_) s = std::max(s, smooth_law_.last_from());
  law_.split(s);
  for (std::size_t i = law_.point_at(s); i + 1 < law_.size(); ++i) {
    if (!(law_.square(i) > 0.0) || law_.s(i + 1) == law_.s(i)) continue;
    TimeTable::Point passing = motion.table.passing(law_.s(i));
    passing.t_s += motion.later_s;
    if (passing.t_s >= earliest_s - kTimeRounding_s && passing.speed > 0.0) return Joint{i, passing};
  }
  return std::nullopt;
}

bool ChainLaw::keep(CartesianPlan& plan, const Joint& joint, double from_s, Ticks origin) noexcept {
  if (smooth_) {
    // Where the plan brakes to its end, what is usual will be another speed.
    const TimeTable& table = smooth_law_.table();
    const double brakes_at = table.position(table.brakes_from_s());
    if (!smooth_law_.keep(plan.table, joint.passing, from_s, origin)) return false;
    for (std::size_t i = law_.point_at(brakes_at); i < law_.size(); ++i) free_jerk(law_.limits(i));
    law_.uncap();
  } else {
    if (!plan.table.can_keep(from_s, joint.passing, TimeTable::kMaxKept)) return false;
    plan.table.keep(from_s, joint.passing, origin);
  }
  law_.drop_front(joint.point);
  law_.start_with(joint.passing.speed * joint.passing.speed);
  return true;
}

void ChainLaw::extend(const CartesianPlan& plan, std::size_t last, double keep_s) noexcept {
  stage_ = Stage::kGrid;
  held_to_ = 0.0;
  lowered_ = false;
  rounds_ = kWindowRounds;
  grid_.extend(plan, law_, last, keep_s);
}

std::size_t ChainLaw::room(const CartesianPlan& plan, double earliest_s) const noexcept {
  const LawMotion motion = this->motion(plan);
  const std::size_t at = law_.point_at(motion.table.position(earliest_s - motion.later_s));
  // With the point that joint_at() adds.
  const std::size_t used = law_.size() + 1 - at + LawGrid::kSparePoints;
  return used < SpeedLaw::kMaxPoints ? (SpeedLaw::kMaxPoints - used) / LawGrid::kWindowPoints : 0;
}

void ChainLaw::plan_again() noexcept {
  stage_ = smooth_ ? Stage::kSmooth : Stage::kLaw;
  if (smooth_) {
    smooth_law_.plan_again(law_);
  } else {
    law_.begin(rounds_);
  }
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
      law_.begin(rounds_);
      stage_ = Stage::kLaw;
      return Progress::kSampled;
    }
    case Stage::kLaw:
      inverses_ = kIntervals;
      if (law_.work(kIntervals) == SpeedLaw::Progress::kWorking) break;
      return end_law(plan);
    case Stage::kSmooth: {
      const bool working = smooth_law_.work(law_, kIntervals) == SmoothLaw::Progress::kWorking;
      inverses_ = smooth_law_.cost();
      if (working) break;
      stage_ = Stage::kDone;
      if (plan.continues && !law_.starts_as_asked()) return Progress::kTooLate;
      finish(plan);
      break;
    }
    case Stage::kDone:
      break;
  }
  return stage_ == Stage::kDone ? Progress::kDone : Progress::kWorking;
}

ChainLaw::Progress ChainLaw::end_law(CartesianPlan& plan) noexcept {
  if (!plan.continues) {
    measure(plan, joint_s_);
    smooth_ = smooth_law_.begin(law_);
  } else if (!law_.starts_as_asked()) {
    if (!law_.ease_start()) return Progress::kTooLate;
    law_.begin(rounds_);
    return Progress::kWorking;
  } else if (smooth_) {
    smooth_law_.extend(law_);
  }
  if (smooth_) {
    stage_ = Stage::kSmooth;
    return Progress::kWorking;
  }
  finish(plan);
  stage_ = Stage::kDone;
  return Progress::kDone;
}

void ChainLaw::lower(const CartesianPlan& plan, const PathCheck::Place& place, double share) noexcept {
  lowered_ = true;
  double from_s = place.from_tick * kTickSeconds, to_s = place.to_tick * kTickSeconds;
  if (smooth_) {
    // A moving average is that of the law around.
    const double half_s = 0.5 * smooth_law_.tau_s(plan.table.position(0.5 * (from_s + to_s)));
    from_s -= half_s;
    to_s += half_s;
  }
  double from = plan.table.position(from_s), to = plan.table.position(to_s);
  if (smooth_ && plan.continues) {
    const bool close_behind = from < law_.s(0) + std::sqrt(law_.start_square()) * tau_s();
    from = std::max(from, law_.s(1));
    to = std::max(to, from);
    // The speed at the joint is given. So at first the law only keeps it, and can still brake behind.
    if (close_behind && to > held_to_) {
      held_to_ = to;
      return law_.cap(law_.s(0), to, law_.start_square());
    }
  }
  law_.lower(from, to, share / place.stretch);
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
  const double from = plan.table.position(0.0);
  for (int step = 1; step <= kJointSteps; ++step) {
    const IkTracking tracking = joints_on_path(plan, arm_, from + (s - from) * step / kJointSteps, joints);
    if (tracking.found) joints = tracking.joints;
  }
  return joints;
}

}  // namespace armature
