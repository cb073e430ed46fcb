#include "cosim/plant/tick_steps.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "cosim/logic/axis_bits.hpp"
#include "cosim/plant/clock.hpp"

namespace armature::cosim {
namespace {

int exponent_of(double x) {
  return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7FF);
}

}  // namespace

// Whole numbers are subtracted without rounding until the magnitude leaves its power of two. The first result beyond is
// rounded to a whole number of its own, twice as large units. So are all later ones up to the next power of two, and to
// the same side, because a count is an even number of those units. Hence one subtraction gives the same result.
double less_pulses(double error, double step, int count) {
  if (std::fabs(step) == 1.0) {
    const double at_once = error - count * step;
    constexpr int kExponentOfHalfLimit = 1023 + 48;
    if (exponent_of(at_once) <= exponent_of(error) + 1 && exponent_of(error) < kExponentOfHalfLimit) return at_once;
  }
  for (int i = 0; i < count; ++i) error -= step;
  return error;
}

void TickSteps::run(const TickPulses& tick, std::span<const ServoDrive> drives, std::uint8_t moving,
                    Mechanics& mechanics, Shafts& shafts) {
  begin(tick, drives);
  std::uint8_t axes = moving;
  for (std::size_t i = 0; i < kAxes; ++i) axes |= tick.axes[i].count != 0 ? bit_of(i) : std::uint8_t{0};
  if (axes == 0) return;
  bool moves = moving != 0;
  for (Cycles now = grid_from(tick.begins); now < tick.ends; now += kPlantStep) {
    const bool rested = !moves;
    const bool before = rested && take_until(now - Cycles{1}, drives, shafts);
    const bool with = take_until(now, drives, shafts);
    // A pulse at the very cycle of the step ends the rest. The first step then comes later.
    if (rested && !before) {
      moves = with;
      continue;
    }
    make_step(now, axes, mechanics, shafts);
    moves = are_moving(shafts);
  }
  take_until(tick.ends - Cycles{1}, drives, shafts);
}

void TickSteps::begin(const TickPulses& tick, std::span<const ServoDrive> drives) {
  constexpr double kFar = std::numeric_limits<double>::max();
  size_ = 0;
  moved_ = 0;
  begins_ = tick.begins;
  taken_.fill(0.0);
  extremes_.smallest_error.fill(kFar);
  extremes_.largest_error.fill(0.0);
  extremes_.least_way.fill(kFar);
  extremes_.most_way.fill(-kFar);
  plain_gears_ = true;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const AxisPulses& pulses = tick.axes[i];
    const ServoDrive& drive = drives[i];
    first_[i] = static_cast<double>((pulses.first - tick.begins).value());
    window_[i] = pulses.count == 0 ? 1.0 : static_cast<double>(pulses.window);
    edges_[i] = 2.0 * pulses.pulses();
    rounding_[i] = window_[i] + 0.25;
    per_two_windows_[i] = 0.5 / window_[i];
    count_is_negative_[i] = pulses.count < 0;
    counts_per_pulse_[i] = (pulses.count < 0 ? -1 : +1) * drive.gear().counts_per_pulse();
    plain_gears_ = plain_gears_ && drive.gear().counts_per_pulse() == 1.0;
    demands_.set(i, drive.demand());
  }
}

// Those that rise up to the cycle `at`. Returns whether there is one. The number of rises is
// floor((edges x elapsed + window) / (2 window)), as AxisPulses::rises_until(); the quarter keeps the product with the
// inverse on the right side of whole numbers.
bool TickSteps::take_until(Cycles at, std::span<const ServoDrive> drives, Shafts& shafts) {
  const auto elapsed = static_cast<double>((at - begins_).value());
  PerAxis<double> more;
  double most = 0.0;
  for (std::size_t i = 0; i < kAxes; ++i) {
    double since = elapsed - first_[i];
    since = since < 0.0 ? 0.0 : since;
    since = since > window_[i] ? window_[i] : since;
    const auto rises = static_cast<std::int32_t>((edges_[i] * since + rounding_[i]) * per_two_windows_[i]);
    more[i] = static_cast<double>(rises) - taken_[i];
    taken_[i] = static_cast<double>(rises);
  }
  for (std::size_t i = 0; i < kAxes; ++i) most = more[i] > most ? more[i] : most;
  if (most == 0.0) return false;
  if (most == 1.0) {
    for (std::size_t i = 0; i < kAxes; ++i) shafts.error[i] -= more[i] * counts_per_pulse_[i];
  } else {
    for (std::size_t i = 0; i < kAxes; ++i) {
      shafts.error[i] = less_pulses(shafts.error[i], counts_per_pulse_[i], static_cast<int>(more[i]));
    }
  }
  if (plain_gears_) {
    for (std::size_t i = 0; i < kAxes; ++i) demands_.reference[i] += more[i] * counts_per_pulse_[i];
  } else {
    for (std::size_t i = 0; i < kAxes; ++i) {
      const auto taken = static_cast<std::int64_t>(taken_[i]);
      const ElectronicGear gear = drives[i].gear().after(count_is_negative_[i] ? -taken : taken);
      demands_.reference[i] = static_cast<double>(gear.whole()) + gear.fraction();
    }
  }
  return true;
}

void TickSteps::make_step(Cycles now, std::uint8_t axes, Mechanics& mechanics, Shafts& shafts) {
  const PerAxis<double> before = shafts.error;
  moved_ |= mechanics.step(axes, demands_, shafts);
  Step& step = steps_[size_++];
  step.began = now;
  step.taken = taken_;
  step.error = shafts.error;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const double size = std::fabs(shafts.error[i]), way = shafts.error[i] - before[i];
    extremes_.smallest_error[i] = size < extremes_.smallest_error[i] ? size : extremes_.smallest_error[i];
    extremes_.largest_error[i] = size > extremes_.largest_error[i] ? size : extremes_.largest_error[i];
    extremes_.least_way[i] = way < extremes_.least_way[i] ? way : extremes_.least_way[i];
    extremes_.most_way[i] = way > extremes_.most_way[i] ? way : extremes_.most_way[i];
  }
}

bool TickSteps::are_moving(const Shafts& shafts) {
  const auto moves = [&](std::size_t axis) {
    return has_bit(demands_.controlled, axis) ? !shafts[axis].at_rest() : !shafts[axis].stands();
  };
  if (moves(mover_)) return true;
  for (mover_ = 0; mover_ + 1 < kAxes && !moves(mover_);) ++mover_;
  return moves(mover_);
}

}  // namespace armature::cosim
