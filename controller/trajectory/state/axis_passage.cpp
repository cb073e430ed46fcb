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

template <class TimeFor>
bool AxisPassage::solve(Changes inside, TimeFor time_for, Changes& solution) const noexcept {
  const auto excess = [&](const Changes& changes) { return changes.excess + changes.velocity * time_for(changes); };
  double inside_excess = excess(inside);
  const double direction = inside_excess < 0.0 ? 1.0 : -1.0;
  Changes outside = changes(direction * limits_.speed);
  double outside_excess = excess(outside);
  if (time_for(outside) >= 0.0 && direction * outside_excess < 0.0) return false;
  const double no_miss = kNoMiss * way_size(inside.duration_s);
  double inside_weight = inside_excess, outside_weight = outside_excess;
  bool was_beyond = false;
  for (int i = 1; i <= kMaxChanges && std::fabs(inside_excess) > no_miss; ++i) {
    double velocity = 0.5 * (inside.velocity + outside.velocity);
    if (time_for(outside) >= 0.0 && i % kBisectEvery != 0) {
      const double secant =
          (inside.velocity * outside_weight - outside.velocity * inside_weight) / (outside_weight - inside_weight);
      if ((secant - inside.velocity) * (secant - outside.velocity) < 0.0) velocity = secant;
    }
    if (velocity == inside.velocity || velocity == outside.velocity) break;
    const Changes middle = changes(velocity);
    const double middle_excess = excess(middle);
    const bool beyond = time_for(middle) < 0.0 || direction * middle_excess > 0.0;
    // An end that stays twice counts less and less (the Illinois rule).
    if (beyond) {
      outside = middle;
      outside_excess = outside_weight = middle_excess;
      if (was_beyond) inside_weight *= 0.5;
    } else {
      inside = middle;
      inside_excess = inside_weight = middle_excess;
      if (!was_beyond) outside_weight *= 0.5;
    }
    was_beyond = beyond;
  }
  const bool better = time_for(outside) >= 0.0 && std::fabs(outside_excess) < std::fabs(inside_excess);
  solution = better ? outside : inside;
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
