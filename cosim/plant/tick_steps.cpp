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
    find_positions(drives, shafts);
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
    begin_[i] = drive.gear().whole() * kSubcountsPerCount;
    plain_gears_ = plain_gears_ && drive.gear().counts_per_pulse() == 1.0;
    demands_.set(i, drive.demand());
  }
}

// Those that rise up to the cycle `at`. Returns whether there is one. The number of rises is
// floor((edges x elapsed + window) / (2 window)), as AxisPulses::rises_until(); the quarter keeps the product with the
// inverse on the right side of whole numbers.
bool TickSteps::take_until(Cycles at, std::span<const ServoDrive> drives, Shafts& shafts) {
  const Pair elapsed = both(static_cast<double>((at - begins_).value()));
  std::array<Pair, kAxisPairs> more;
  Pair most_of_pair{};
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    const Pair since = smaller(larger(elapsed - first_.pair(i), both(0.0)), window_.pair(i));
    const Pair rises = without_fraction((edges_.pair(i) * since + rounding_.pair(i)) * per_two_windows_.pair(i));
    more[i] = rises - taken_.pair(i);
    taken_.set_pair(i, rises);
    most_of_pair = larger(more[i], most_of_pair);
  }
  const double most = most_of_pair[0] > most_of_pair[1] ? most_of_pair[0] : most_of_pair[1];
  if (most == 0.0) return false;
  if (most == 1.0) {
    for (std::size_t i = 0; i < kAxisPairs; ++i) {
      shafts.error.set_pair(i, shafts.error.pair(i) - more[i] * counts_per_pulse_.pair(i));
    }
  } else {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const int count = static_cast<int>(more[axis / 2][axis % 2]);
      shafts.error[axis] = less_pulses(shafts.error[axis], counts_per_pulse_[axis], count);
    }
  }
  if (plain_gears_) {
    for (std::size_t i = 0; i < kAxisPairs; ++i) {
      demands_.reference.set_pair(i, demands_.reference.pair(i) + more[i] * counts_per_pulse_.pair(i));
    }
  } else {
    for (std::size_t i = 0; i < kAxes; ++i) {
      const ElectronicGear gear = gear_of(drives[i], i);
      demands_.reference[i] = static_cast<double>(gear.whole()) + gear.fraction();
    }
  }
  return true;
}

void TickSteps::make_step(Cycles now, std::uint8_t axes, Mechanics& mechanics, Shafts& shafts) {
  const AxisNumbers before = shafts.error;
  moved_ |= mechanics.step(axes, demands_, shafts);
  Step& step = steps_[size_++];
  step.began = now;
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    const Pair size = magnitude(shafts.error.pair(i)), way = shafts.error.pair(i) - before.pair(i);
    extremes_.smallest_error.set_pair(i, smaller(size, extremes_.smallest_error.pair(i)));
    extremes_.largest_error.set_pair(i, larger(size, extremes_.largest_error.pair(i)));
    extremes_.least_way.set_pair(i, smaller(way, extremes_.least_way.pair(i)));
    extremes_.most_way.set_pair(i, larger(way, extremes_.most_way.pair(i)));
  }
}

// As ServoDrive::position_at(), operation for operation.
void TickSteps::find_positions(std::span<const ServoDrive> drives, const Shafts& shafts) {
  constexpr double kFarCounts = 0x1.0p26;  // further than a drive without an alarm, and within rounded_down()
  constexpr auto kSubcounts = static_cast<double>(kSubcountsPerCount);
  Step& step = steps_[size_ - 1];
  WholePair far{};
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    const Pair error = shafts.error.pair(i);
    const Pair from_reference = rounded_down(error * both(kSubcounts) + both(0.5));
    const Pair reference = taken_.pair(i) * counts_per_pulse_.pair(i) * both(kSubcounts);
    step.subcounts.set_pair(i, begin_.pair(i) + whole_numbers(reference + from_reference));
    far |= magnitude(error) > both(kFarCounts);
  }
  if (plain_gears_ && !any(far)) return;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Subcounts position = ServoDrive::position_at(gear_of(drives[axis], axis), shafts.error[axis]);
    step.subcounts[axis] = position.value();
  }
}

ElectronicGear TickSteps::gear_of(const ServoDrive& drive, std::size_t axis) const {
  const auto taken = static_cast<std::int64_t>(taken_[axis]);
  return drive.gear().after(count_is_negative_[axis] ? -taken : taken);
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
