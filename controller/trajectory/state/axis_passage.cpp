#include "controller/trajectory/state/axis_passage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace armature {
namespace {

// The end of a motion may differ from the wanted one by rounding: in parts of the positions and the way.
constexpr double kNoMiss = 1e-15, kRoundingMiss = 1e-13;
// Regula falsi with bisections in between.
constexpr int kMaxChanges = 80;
constexpr int kBisectEvery = 4;

// In reversed time, the velocity has the opposite sign, and so has the jerk.
AxisState reversed(const AxisState& state) {
  return {state.position, -state.velocity, state.accel};
}

// The velocity when the acceleration has returned to 0 at once.
double released(ProfileKind kind, const AxisState& state, const TimeLawLimits& limits) {
  const double change = kind == ProfileKind::kSCurve ? 0.5 * state.accel * std::fabs(state.accel) / limits.jerk : 0.0;
  return std::clamp(state.velocity + change, -limits.speed, limits.speed);
}

}  // namespace

AxisPassage::Side::Side(const ReachRules& rules, const AxisState& of, const TimeLawLimits& limits) noexcept
    : given{of}, state{of} {
  if (given.at_rest()) return;
  lead = rules.lead(given, limits);
  lead_s = lead.duration_s();
  state = lead.after_all(given);
}

AxisPassage::AxisPassage(ProfileKind kind, const AxisState& start, const AxisState& end,
                         const TimeLawLimits& limits) noexcept
    : rules_{rules_of(kind)},
      limits_{limits},
      at_rest_{start.at_rest() && end.at_rest() && start.position == end.position},
      start_{rules_, start, limits},
      end_{rules_, reversed(end), limits},
      first_velocities_{released(kind, start_.state, limits), -released(kind, end_.state, limits)} {}

AxisPassage::Changes AxisPassage::changes(double velocity) const noexcept {
  const Phases first = rules_.ramp(start_.state, velocity, limits_);
  const Phases last = rules_.ramp(end_.state, -velocity, limits_);
  return {.velocity = velocity,
          .duration_s = start_.lead_s + first.duration_s() + last.duration_s() + end_.lead_s,
          .excess = first.after_all(start_.state).position - last.after_all(end_.state).position};
}

double AxisPassage::way_size(double duration_s) const noexcept {
  return 1.0 + std::fabs(start_.given.position) + std::fabs(end_.given.position) + limits_.speed * duration_s;
}

double AxisPassage::middle_of(const Bound& a, const Bound& b) noexcept {
  return 0.5 * (a.changes.velocity + b.changes.velocity);
}

double AxisPassage::secant_of(const Bound& inside, const Bound& outside) noexcept {
  const double from = inside.changes.velocity, to = outside.changes.velocity;
  const double secant = (from * outside.weight - to * inside.weight) / (outside.weight - inside.weight);
  return (secant - from) * (secant - to) < 0.0 ? secant : middle_of(inside, outside);
}

template <class TimeFor>
bool AxisPassage::solve(const Changes& first, TimeFor time_for, Changes& solution) const noexcept {
  const auto bound_at = [&](const Changes& changes) {
    const double excess = changes.excess + changes.velocity * time_for(changes);
    return Bound{changes, excess, excess};
  };
  Bound inside = bound_at(first);
  const double direction = inside.excess < 0.0 ? 1.0 : -1.0;
  Bound outside = bound_at(changes(direction * limits_.speed));
  if (time_for(outside.changes) >= 0.0 && direction * outside.excess < 0.0) return false;
  const double no_miss = kNoMiss * way_size(first.duration_s);
  bool was_beyond = false;
  for (int i = 1; i <= kMaxChanges && std::fabs(inside.excess) > no_miss; ++i) {
    const bool by_secant = time_for(outside.changes) >= 0.0 && i % kBisectEvery != 0;
    const double velocity = by_secant ? secant_of(inside, outside) : middle_of(inside, outside);
    if (velocity == inside.changes.velocity || velocity == outside.changes.velocity) break;
    const Bound middle = bound_at(changes(velocity));
    const bool beyond = time_for(middle.changes) < 0.0 || direction * middle.excess > 0.0;
    // A bound that stays twice counts less and less (the Illinois rule).
    if (beyond) {
      outside = middle;
      if (was_beyond) inside.weight *= 0.5;
    } else {
      inside = middle;
      if (!was_beyond) outside.weight *= 0.5;
    }
    was_beyond = beyond;
  }
  const bool better = time_for(outside.changes) >= 0.0 && std::fabs(outside.excess) < std::fabs(inside.excess);
  solution = better ? outside.changes : inside.changes;
  return true;
}

PhaseLaw AxisPassage::law_of(double velocity, double constant_s) const noexcept {
  PhaseLaw law{start_.given};
  for (const Phase& phase : start_.lead) law.append(phase);
  for (const Phase& phase : rules_.ramp(start_.state, velocity, limits_)) law.append(phase);
  if (constant_s > 0.0) law.append({constant_s, 0.0, 0.0});
  const auto append_reversed = [&law](const Phases& phases) {
    for (std::size_t i = phases.size(); i-- > 0;) {
      const Phase& phase = phases[i];
      law.append({phase.duration_s, phase.accel + phase.jerk * phase.duration_s, -phase.jerk});
    }
  };
  append_reversed(rules_.ramp(end_.state, -velocity, limits_));
  append_reversed(end_.lead);
  law.set_end(end_.given.position, -end_.given.velocity);
  return law;
}

double AxisPassage::shortest_s() const noexcept {
  if (at_rest_) return 0.0;
  double shortest_s = std::numeric_limits<double>::infinity();
  for (const double velocity : first_velocities_) {
    const Changes first = changes(velocity);
    Changes solution;
    if (solve(
            first, [](const Changes&) { return 0.0; }, solution)) {
      shortest_s = std::min(shortest_s, solution.duration_s);
      continue;
    }
    const Changes fastest = changes(first.excess < 0.0 ? limits_.speed : -limits_.speed);
    shortest_s = std::min(shortest_s, fastest.duration_s + std::fabs(fastest.excess) / limits_.speed);
  }
  return shortest_s;
}

bool AxisPassage::motion(double duration_s, PhaseLaw& law) const noexcept {
  if (at_rest_) {
    law = PhaseLaw{start_.given};
    return true;
  }
  const auto time_for = [duration_s](const Changes& changes) { return duration_s - changes.duration_s; };
  for (const double velocity : first_velocities_) {
    const Changes first = changes(velocity);
    Changes solution;
    if (!(time_for(first) >= 0.0) || !solve(first, time_for, solution)) continue;
    const double constant_s = time_for(solution);
    const double miss = solution.excess + solution.velocity * constant_s;
    if (std::fabs(miss) > kRoundingMiss * way_size(duration_s)) continue;
    law = law_of(solution.velocity, constant_s);
    return true;
  }
  return false;
}

}  // namespace armature
