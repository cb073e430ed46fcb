// The pulses of a whole tick at the drives of all axes, two axes at a time: how many have risen, and what they do to
// the errors of the shafts.
#pragma once

#include <cstddef>
#include <span>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "cosim/logic/axis_pairs.hpp"
#include "cosim/logic/whole_tick.hpp"
#include "cosim/plant/servo_drive.hpp"

namespace armature::cosim {

// The error after `count` pulses (0..200), each of which takes `step` away from it: rounded after each one.
[[nodiscard]] double less_pulses(double error, double step, int count);

class TickRises {
 public:
  void begin(const TickPulses& tick, std::span<const ServoDrive> drives);

  // Pulses that have risen up to this number of cycles after the start of the tick, without their sign. The number is
  // floor((edges x elapsed + window) / (2 window)), as AxisPulses::rises_until(); the quarter keeps the product with
  // the inverse on the right side of whole numbers.
  [[nodiscard]] Pair until(std::size_t i, Pair elapsed) const {
    const Pair since = smaller(larger(elapsed - first_.pair(i), both(0.0)), window_.pair(i));
    return without_fraction((edges_.pair(i) * since + rounding_.pair(i)) * per_two_windows_.pair(i));
  }
  // The error after so many more of them.
  [[nodiscard]] Pair less(std::size_t i, Pair error, Pair more) const {
    const Pair at_once = less_at_once(i, error, more);
    return any(more > both(1.0)) ? less_one_by_one(i, error, more, at_once) : at_once;
  }
  // The same if the lanes of is_exact() are set, or if there is at most one more.
  [[nodiscard]] Pair less_at_once(std::size_t i, Pair error, Pair more) const {
    return error - more * counts_per_pulse_.pair(i);
  }
  [[nodiscard]] WholePair is_exact(std::size_t i, Pair error, Pair more, Pair at_once) const {
    return same_at_once(error, counts_per_pulse_.pair(i), at_once) | (more <= both(1.0));
  }
  // Whether at most one rises in so many cycles.
  [[nodiscard]] bool are_apart(std::size_t i, Cycles cycles) const {
    return !any(edges_.pair(i) * both(0.5 * static_cast<double>(cycles.value())) > window_.pair(i));
  }
  // Counts by which one of them moves the reference, with its sign.
  [[nodiscard]] const AxisNumbers& counts_per_pulse() const { return counts_per_pulse_; }

 private:
  // Lanes in which subtracting many steps gives the same at once as one by one. Whole numbers are subtracted without
  // rounding until the magnitude leaves its power of two. The first result beyond is rounded to a whole number of its
  // own, twice as large units. So are all later ones up to the next power of two, and to the same side, because a count
  // is an even number of those units.
  [[nodiscard]] static WholePair same_at_once(Pair error, Pair step, Pair at_once) {
    constexpr double kHalfLimit = 0x1.0p48;
    const Pair before = power_of_two(error);
    return (magnitude(step) == both(1.0)) & (power_of_two(at_once) <= both(2.0) * before) & (before < both(kHalfLimit));
  }
  friend double less_pulses(double error, double step, int count);
  [[nodiscard]] Pair less_one_by_one(std::size_t i, Pair error, Pair more, Pair at_once) const;

  // Their edges, from the start of the tick.
  AxisNumbers first_, window_, edges_, rounding_, per_two_windows_;
  AxisNumbers counts_per_pulse_;
};

}  // namespace armature::cosim
