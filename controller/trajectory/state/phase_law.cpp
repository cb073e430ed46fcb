#include "controller/trajectory/state/phase_law.hpp"

#include <algorithm>
#include <cmath>

namespace armature {

AxisState after(const AxisState& s, double jerk, double t_s) noexcept {
  return {.position = s.position + (s.velocity + (0.5 * s.accel + jerk * t_s / 6.0) * t_s) * t_s,
          .velocity = s.velocity + (s.accel + 0.5 * jerk * t_s) * t_s,
          .accel = s.accel + jerk * t_s};
}

AxisState state_after(double newest, double previous, double oldest, double step_s) noexcept {
  const double step = newest - previous, bend = step - (previous - oldest);
  return {.position = newest, .velocity = (step + 0.5 * bend) / step_s, .accel = bend / (step_s * step_s)};
}

double Phases::duration_s() const noexcept {
  double sum_s = 0.0;
  for (const Phase& phase : *this) sum_s += phase.duration_s;
  return sum_s;
}

AxisState Phases::after_all(const AxisState& state) const noexcept {
  AxisState now = state;
  for (const Phase& phase : *this) {
    now.accel = phase.accel;
    now = after(now, phase.jerk, phase.duration_s);
  }
  return now;
}

void PhaseLaw::append(const Phase& phase) noexcept {
  assert(count_ < kMaxPhases);
  Knot& knot = knots_[count_++];
  knot = {duration_s_, {end_.position, end_.velocity, phase.accel}, phase.jerk};
  end_ = after(knot.state, phase.jerk, phase.duration_s);
  end_.accel = 0.0;
  duration_s_ += phase.duration_s;
}

AxisState PhaseLaw::at(double t_s) const noexcept {
  if (!(t_s < duration_s_)) return after(end_, 0.0, t_s - duration_s_);
  std::size_t i = 0;
  while (i + 1 < count_ && t_s >= knots_[i + 1].start_s) ++i;
  return after(knots_[i].state, knots_[i].jerk, std::max(t_s - knots_[i].start_s, 0.0));
}

PhaseLaw::Extent PhaseLaw::extent() const noexcept {
  Extent extent{end_.position, end_.position};
  const auto include = [&](double position) {
    extent.least = std::min(extent.least, position);
    extent.largest = std::max(extent.largest, position);
  };
  for (std::size_t i = 0; i < count_; ++i) {
    const auto& [start_s, state, jerk] = knots_[i];
    include(state.position);
    // Where the velocity changes in one direction and keeps its sign, it does not turn round.
    const double end_velocity = i + 1 < count_ ? knots_[i + 1].state.velocity : end_.velocity;
    const double end_accel = state.accel + jerk * length_s(i);
    if (state.accel * end_accel >= 0.0 && state.velocity * end_velocity > 0.0) continue;
    // It turns round where velocity + accel t + jerk t^2 / 2 = 0; the two roots without cancellation.
    const double discriminant = state.accel * state.accel - 2.0 * jerk * state.velocity;
    if (discriminant < 0.0) continue;
    const double root = std::sqrt(discriminant);
    const double sum = -(state.accel + (state.accel < 0.0 ? -root : root));
    for (const double t_s : {sum / jerk, 2.0 * state.velocity / sum}) {
      if (t_s > 0.0 && t_s < length_s(i)) include(after(state, jerk, t_s).position);
    }
  }
  return extent;
}

double PhaseLaw::peak_speed() const noexcept {
  double peak = std::fabs(end_.velocity);
  for (std::size_t i = 0; i < count_; ++i) {
    const auto& [start_s, state, jerk] = knots_[i];
    peak = std::max(peak, std::fabs(state.velocity));
    const double t_s = -state.accel / jerk;
    if (t_s > 0.0 && t_s < length_s(i)) peak = std::max(peak, std::fabs(after(state, jerk, t_s).velocity));
  }
  return peak;
}

double PhaseLaw::peak_accel() const noexcept {
  double peak = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const auto& [start_s, state, jerk] = knots_[i];
    peak = std::max({peak, std::fabs(state.accel), std::fabs(state.accel + jerk * length_s(i))});
  }
  return peak;
}

}  // namespace armature
