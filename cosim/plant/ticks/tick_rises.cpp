#include "cosim/plant/ticks/tick_rises.hpp"

namespace armature::cosim {
double less_pulses(double error, double step, int count) {
  const Pair at_once = both(error) - both(count) * both(step);
  if (any(TickRises::same_at_once(both(error), both(step), at_once))) return at_once[0];
  for (int i = 0; i < count; ++i) error -= step;
  return error;
}

void TickRises::begin(const TickPulses& tick, std::span<const ServoDrive> drives) {
  for (std::size_t i = 0; i < kAxes; ++i) {
    const AxisPulses& pulses = tick.axes[i];
    first_[i] = static_cast<double>((pulses.first - tick.begins).value());
    window_[i] = pulses.count == 0 ? 1.0 : static_cast<double>(pulses.window);
    edges_[i] = 2.0 * pulses.pulses();
    const double counts = drives[i].gear().counts_per_pulse();
    counts_per_pulse_[i] = pulses.count < 0 ? -counts : counts;
  }
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    rounding_.set_pair(i, window_.pair(i) + both(0.25));
    per_two_windows_.set_pair(i, both(0.5) / window_.pair(i));
  }
}

Pair TickRises::less_one_by_one(std::size_t i, Pair error, Pair more, Pair at_once) const {
  const Pair step = counts_per_pulse_.pair(i);
  const WholePair same = is_exact(i, error, more, at_once);
  for (std::size_t lane = 0; lane < 2; ++lane) {
    if (same[lane] == 0) at_once[lane] = less_pulses(error[lane], step[lane], static_cast<int>(more[lane]));
  }
  return at_once;
}

}  // namespace armature::cosim
