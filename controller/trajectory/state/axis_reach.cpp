#include "controller/trajectory/state/axis_reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace armature {
namespace {

// The rules know one direction: the other one is seen in a mirror.
AxisState mirrored(const AxisState& state, double sign) {
  return {sign * state.position, sign * state.velocity, sign * state.accel};
}

// Steps through phases, then rests.
class PhaseWalk {
 public:
  PhaseWalk(const Phases& phases, double sign, double share) : next_{phases.begin()}, end_{phases.end()} {
    sign_ = sign * share;
    load();
  }
  [[nodiscard]] double left_s() const { return left_s_; }
  [[nodiscard]] double accel() const { return accel_; }
  [[nodiscard]] double jerk() const { return jerk_; }
  void advance(double duration_s) {
    accel_ += jerk_ * duration_s;
    if (duration_s < left_s_) {
      left_s_ -= duration_s;
    } else {
      load();
    }
  }

 private:
  void load() {
    const bool over = next_ == end_;
    left_s_ = over ? std::numeric_limits<double>::infinity() : next_->duration_s;
    accel_ = over ? 0.0 : sign_ * next_->accel;
    jerk_ = over ? 0.0 : sign_ * next_->jerk;
    if (!over) ++next_;
  }

  const Phase* next_;
  const Phase* end_;
  double sign_, left_s_ = 0.0, accel_ = 0.0, jerk_ = 0.0;
};

// Shares of a motion beyond 1 are extrapolation.
constexpr double kMaxShare = 1.0 + 1e-6;
// The shortest duration and the motion of that duration are computed on different ways.
constexpr double kDurationRounding = 1e-13;
// A few units in the last place.
constexpr double kPositionRounding = 1e-15;

}  // namespace

AxisReach::AxisReach(ProfileKind kind, const AxisState& start, const TimeLawLimits& limits) noexcept
    : rules_{rules_of(kind)},
      limits_{limits},
      start_{start},
      lead_{start.at_rest() ? Phases{} : rules_.lead(start_, limits_)},
      lead_end_{lead_.after_all(start_)},
      lead_s_{lead_.duration_s()},
      stop_{start.at_rest() ? Phases{} : rules_.ramp(lead_end_, 0.0, limits_)},
      stop_position_{stop_.after_all(lead_end_).position} {}

bool AxisReach::stops_at(double target) const noexcept {
  const double size = std::fabs(target) + std::fabs(stop_position_ - start_.position);
  return std::fabs(target - stop_position_) <= kPositionRounding * size;
}

double AxisReach::shortest_s(double target) const noexcept {
  if (stops_at(target)) return stop_s();
  const double sign = sign_to(target);
  const double distance = sign * (target - lead_end_.position);
  const double rest_s = rules_.shortest_s(mirrored(lead_end_, sign), distance, limits_);
  return lead_s_ + std::max(rest_s, stop_.duration_s()) * (1.0 + kDurationRounding);
}

template <class Take>
void AxisReach::walk(double target, double duration_s, Take take) const noexcept {
  for (const Phase& phase : lead_) {
    if (!take(phase)) return;
  }
  const double sign = sign_to(target);
  const bool stops = stops_at(target);
  const Phases far = stops ? Phases{} : rules_.farthest(mirrored(lead_end_, sign), duration_s - lead_s_, limits_);
  double share = 0.0;
  if (!stops) {
    const double farthest = sign * far.after_all(mirrored(lead_end_, sign)).position;
    const double reach = sign * (farthest - stop_position_), wanted = sign * (target - stop_position_);
    share = reach > 0.0 ? std::min(wanted / reach, kMaxShare) : 0.0;
  }
  PhaseWalk outer{far, sign, share}, inner{stop_, 1.0, 1.0 - share};
  while (true) {
    const double step_s = std::min(outer.left_s(), inner.left_s());
    if (step_s == std::numeric_limits<double>::infinity()) return;
    if (!take(Phase{step_s, outer.accel() + inner.accel(), outer.jerk() + inner.jerk()})) return;
    outer.advance(step_s);
    inner.advance(step_s);
  }
}

AxisReach::Motion AxisReach::motion(double target, double duration_s) const noexcept {
  Motion motion;
  motion.miss = this->motion(target, duration_s, motion.law);
  return motion;
}

double AxisReach::motion(double target, double duration_s, PhaseLaw& law) const noexcept {
  law.restart(start_);
  walk(target, duration_s, [&law](const Phase& phase) {
    law.append(phase);
    return true;
  });
  const double miss = std::fabs(target - law.end().position);
  law.set_end(target, 0.0);
  return miss;
}

AxisState AxisReach::on_motion(double target, double duration_s, double t_s) const noexcept {
  AxisState state{start_.position, start_.velocity, 0.0};
  double start_s = 0.0;
  bool reached = false;
  walk(target, duration_s, [&](const Phase& phase) {
    const double end_s = start_s + phase.duration_s;
    reached = t_s < end_s;
    state = after({state.position, state.velocity, phase.accel}, phase.jerk,
                  reached ? std::max(t_s - start_s, 0.0) : phase.duration_s);
    start_s = end_s;
    return !reached;
  });
  return reached ? state : after({.position = target}, 0.0, t_s - start_s);
}

PhaseLaw plan_to_rest(ProfileKind kind, const AxisState& start, double target, const TimeLawLimits& limits) noexcept {
  const AxisReach reach{kind, start, limits};
  return reach.motion(target, reach.shortest_s(target)).law;
}

PhaseLaw plan_to_velocity(ProfileKind kind, const AxisState& start, double velocity,
                          const TimeLawLimits& limits) noexcept {
  const ReachRules& rules = rules_of(kind);
  const Phases lead = rules.lead(start, limits);
  const AxisState lead_end = lead.after_all(start);
  PhaseLaw law{start};
  for (const Phase& phase : lead) law.append(phase);
  for (const Phase& phase : rules.ramp(lead_end, velocity, limits)) law.append(phase);
  law.set_end(law.end().position, velocity);
  return law;
}

}  // namespace armature
