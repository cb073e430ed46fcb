#include "cosim/plant/ticks/tick_steps.hpp"

#include <utility>

#include "cosim/logic/axis_bits.hpp"
#include "cosim/plant/clock.hpp"
#include "cosim/plant/position_loops.hpp"

namespace armature::cosim {

namespace {

constexpr double kNearCounts = 0x1.0p26;  // a drive without an alarm is nearer; within rounded_down()

}  // namespace

void TickSteps::run(const TickPulses& tick, std::span<const ServoDrive> drives, std::uint8_t moving,
                    Mechanics& mechanics, Shafts& shafts) {
  begin(tick, drives);
  std::uint8_t axes = moving;
  for (std::size_t i = 0; i < kAxes; ++i) axes |= tick.axes[i].count != 0 ? bit_of(i) : std::uint8_t{0};
  if (axes == 0) return;
  const bool apart = moving != 0 && plain_gears_ && demands_.controlled == kAllAxes;
  const PositionLoops* const loops = apart ? mechanics.loops() : nullptr;
  if (loops != nullptr && step_apart(tick.ends, *loops, shafts)) {
    moved_ = axes;
  } else {
    step_together(tick.ends, axes, moving != 0, mechanics, drives, shafts);
  }
}

void TickSteps::begin(const TickPulses& tick, std::span<const ServoDrive> drives) {
  begins_ = tick.begins;
  size_ = 0;
  moved_ = 0;
  rises_.begin(tick, drives);
  plain_gears_ = true;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const ServoDrive& drive = drives[i];
    begin_[i] = drive.gear().whole() * kSubcountsPerCount;
    plain_gears_ = plain_gears_ && drive.gear().counts_per_pulse() == 1.0;
    demands_.set(i, drive.demand());
  }
}

bool TickSteps::step_apart(Cycles ends, const PositionLoops& loops, Shafts& shafts) {
  for (Cycles now = grid_from(begins_); now < ends; now += kPlantStep) began_[size_++] = now;
  Shafts moved = shafts;
  bool exact = true, moves = false;
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    const WholePair rested = step_pair(i, ends, loops, moved, exact);
    moves = moves || any(~rested);
  }
  if (!exact || !moves) return false;
  shafts = moved;
  return true;
}

// Returns the lanes that have rested after a step. The loop has no calls, which would move all registers to memory.
WholePair TickSteps::step_pair(std::size_t i, Cycles ends, const PositionLoops& loops, Shafts& shafts, bool& exact) {
  constexpr Pair kStep = {static_cast<double>(kPlantStep.value()), static_cast<double>(kPlantStep.value())};
  const bool apart = rises_.are_apart(i, kPlantStep);
  Pair error = shafts.error.pair(i), speed = shafts.speed.pair(i), taken{};
  Pair elapsed = both(static_cast<double>((began_[0] - begins_).value()));
  Extremes::OfPair extremes;
  PositionLoops::Events events;
  WholePair inexact{};
  const auto take = [&](Pair until) {
    const Pair rises = rises_.until(i, until), more = rises - std::exchange(taken, rises);
    const Pair less = rises_.less_at_once(i, error, more);
    if (!apart) inexact |= ~rises_.is_exact(i, error, more, less);
    error = less;
  };
  for (std::size_t step = 0; step < size_; ++step, elapsed += kStep) {
    take(elapsed);
    const Pair before = error;
    loops.step(i, error, speed, events);
    extremes.add(before, error);
    set_positions(step, i, near_positions(i, error, taken));
  }
  take(both(static_cast<double>((ends - begins_).value() - 1)));
  shafts.error.set_pair(i, error);
  shafts.speed.set_pair(i, speed);
  extremes_.set(i, extremes);
  exact = exact && !any(inexact | ~events.within | (extremes.largest_error > both(kNearCounts)));
  return events.rested;
}

void TickSteps::step_together(Cycles ends, std::uint8_t axes, bool moves, Mechanics& mechanics,
                              std::span<const ServoDrive> drives, Shafts& shafts) {
  size_ = 0;
  taken_.fill(0.0);
  extremes_ = {};
  for (Cycles now = grid_from(begins_); now < ends; now += kPlantStep) {
    const bool rested = !moves;
    const bool before = rested && take_until(now - Cycles{1}, drives, shafts);
    const bool with = take_until(now, drives, shafts);
    // A pulse at the very cycle of the step ends the rest. The first step then comes later.
    if (rested && !before) {
      moves = with;
      continue;
    }
    make_step(now, axes, mechanics, drives, shafts);
    moves = are_moving(shafts);
  }
  take_until(ends - Cycles{1}, drives, shafts);
}

// Those that rise up to the cycle `at`. Returns whether there is one.
bool TickSteps::take_until(Cycles at, std::span<const ServoDrive> drives, Shafts& shafts) {
  const Pair elapsed = both(static_cast<double>((at - begins_).value()));
  WholePair some{};
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    const Pair rises = rises_.until(i, elapsed), more = rises - taken_.pair(i);
    some |= more > both(0.0);
    taken_.set_pair(i, rises);
    shafts.error.set_pair(i, rises_.less(i, shafts.error.pair(i), more));
    demands_.reference.set_pair(i, demands_.reference.pair(i) + more * rises_.counts_per_pulse().pair(i));
  }
  if (!any(some)) return false;
  for (std::size_t i = 0; i < kAxes && !plain_gears_; ++i) {
    const ElectronicGear gear = gear_after(drives[i], i, taken_[i]);
    demands_.reference[i] = static_cast<double>(gear.whole()) + gear.fraction();
  }
  return true;
}

void TickSteps::make_step(Cycles now, std::uint8_t axes, Mechanics& mechanics, std::span<const ServoDrive> drives,
                          Shafts& shafts) {
  const AxisNumbers before = shafts.error;
  moved_ |= mechanics.step(axes, demands_, shafts);
  began_[size_] = now;
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    Extremes::OfPair extremes = extremes_.pair(i);
    extremes.add(before.pair(i), shafts.error.pair(i));
    extremes_.set(i, extremes);
    set_positions(size_, i, positions(i, shafts.error.pair(i), taken_.pair(i), drives));
  }
  ++size_;
}

WholePair TickSteps::positions(std::size_t i, Pair error, Pair taken, std::span<const ServoDrive> drives) const {
  WholePair subcounts = near_positions(i, error, taken);
  if (plain_gears_ && !any(magnitude(error) > both(kNearCounts))) return subcounts;
  for (std::size_t lane = 0; lane < 2; ++lane) {
    const std::size_t axis = 2 * i + lane;
    subcounts[lane] = ServoDrive::position_at(gear_after(drives[axis], axis, taken[lane]), error[lane]).value();
  }
  return subcounts;
}

// With plain gears and below kNearCounts. As ServoDrive::position_at(), operation for operation.
inline WholePair TickSteps::near_positions(std::size_t i, Pair error, Pair taken) const {
  constexpr auto kSubcounts = static_cast<double>(kSubcountsPerCount);
  const Pair from_reference = rounded_down(error * both(kSubcounts) + both(0.5));
  const Pair reference = taken * rises_.counts_per_pulse().pair(i) * both(kSubcounts);
  return begin_.pair(i) + whole_numbers(reference + from_reference);
}

// `taken`: without the sign.
ElectronicGear TickSteps::gear_after(const ServoDrive& drive, std::size_t axis, double taken) const {
  const auto pulses = static_cast<std::int64_t>(taken);
  return drive.gear().after(rises_.counts_per_pulse()[axis] < 0 ? -pulses : pulses);
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
