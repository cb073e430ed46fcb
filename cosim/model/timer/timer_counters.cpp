#include "cosim/model/timer/timer_counters.hpp"

#include <algorithm>
#include <limits>

namespace armature::cosim::model {
namespace {

constexpr std::uint8_t kExtraShowsOfCascade = 2;

// Edges until a counter of this width wraps; the last of them ends the period.
template <class Word>
constexpr std::uint64_t edges_to_end(Word count, bool down) {
  return std::uint64_t{down ? count : static_cast<Word>(~count)} + 1;
}

// 0 is a whole 64-bit period, which never ends either.
constexpr Cycles after(Cycles at, std::uint64_t edges) {
  constexpr std::uint64_t kTooFar = std::uint64_t{1} << 62;
  if (edges == 0 || edges >= kTooFar) return kNever;
  return at + Cycles{static_cast<std::int64_t>(edges)};
}

constexpr std::uint32_t kOneDown = std::numeric_limits<std::uint32_t>::max();

}  // namespace

std::uint64_t TimerCounters::wide() const {
  return std::uint64_t{counters_[1].count} << 32 | counters_[0].count;
}

// A carry moves the upper half away from a wrapped value.
void TimerCounters::set_wide(std::uint64_t count) {
  const auto upper = static_cast<std::uint32_t>(count >> 32);
  if (upper != counters_[1].count) counters_[1].wrapped = false;
  counters_[0].count = static_cast<std::uint32_t>(count);
  counters_[1].count = upper;
}

std::uint32_t TimerCounters::count(unsigned timer, Cycles at) const {
  const auto edges = static_cast<std::uint64_t>((at - at_).value());
  if (wide_step_ != 0) return static_cast<std::uint32_t>((wide() + edges * wide_step_) >> (32 * timer));
  return counters_[timer].count + static_cast<std::uint32_t>(edges) * counters_[timer].step;
}

void TimerCounters::catch_up(Cycles at) {
  const auto edges = static_cast<std::uint64_t>((at - at_).value());
  if (wide_step_ != 0) {
    set_wide(wide() + edges * wide_step_);
  } else {
    for (Counter& counter : counters_) counter.count += static_cast<std::uint32_t>(edges) * counter.step;
  }
  at_ = at;
}

TimerCounters::Motion TimerCounters::motion(unsigned timer, const TimerRegisters& registers, Mode mode,
                                            bool reloads_itself) const {
  if (registers.has(timer_bits::kLoad)) return Motion::kLoads;
  if (!registers.has(timer_bits::kRun) || mode.frozen) return Motion::kStands;
  const Counter& counter = counters_[timer];
  if (!counter.wrapped || registers.has(timer_bits::kCapture)) return Motion::kCounts;
  if (counter.shows > 0) return Motion::kShowsEnd;
  return registers.has(timer_bits::kReload) && reloads_itself ? Motion::kReloads : Motion::kStands;
}

TimerCounters::Motion TimerCounters::motion_of_second(Motion first, const TimerRegisterPair& registers,
                                                      Mode mode) const {
  if (mode.pwm && first == Motion::kReloads && registers[1].has(timer_bits::kRun)) return Motion::kReloads;
  return motion(1, registers[1], mode, !mode.pwm || !registers[0].has(timer_bits::kRun));
}

unsigned TimerCounters::edge(Cycles at, const TimerRegisterPair& registers, Mode mode) {
  catch_up(at - Cycles{1});
  at_ = at;
  const Motion first = motion(0, registers[0], mode, true);
  if (mode.cascade) return move_wide(first, registers) ? 1u : 0u;
  const Motion second = motion_of_second(first, registers, mode);
  const unsigned first_ends = move_alone(0, first, registers[0]) ? 1u : 0u;
  return first_ends | (move_alone(1, second, registers[1]) ? 2u : 0u);
}

void TimerCounters::load(unsigned timer, std::uint32_t start) {
  counters_[timer].count = start;
  counters_[timer].wrapped = false;
}

bool TimerCounters::move_alone(unsigned timer, Motion motion, const TimerRegisters& registers) {
  Counter& counter = counters_[timer];
  switch (motion) {
    case Motion::kStands:
      return false;
    case Motion::kLoads:
    case Motion::kReloads:
      load(timer, registers.start);
      return false;
    case Motion::kShowsEnd:
      --counter.shows;
      return false;
    case Motion::kCounts:
      break;
  }
  const bool down = registers.has(timer_bits::kDown);
  counter.wrapped = !registers.has(timer_bits::kCapture) && edges_to_end(counter.count, down) == 1;
  counter.count += down ? kOneDown : 1;
  counter.shows = 0;
  return counter.wrapped;
}

bool TimerCounters::move_wide(Motion motion, const TimerRegisterPair& registers) {
  Counter& lower = counters_[0];
  bool ends = false;
  switch (motion) {
    case Motion::kStands:
      break;
    case Motion::kLoads:
      load(0, registers[0].start);
      break;
    case Motion::kReloads:
      load(0, registers[0].start);
      load(1, registers[1].start);
      break;
    case Motion::kShowsEnd:
      --lower.shows;
      break;
    case Motion::kCounts:
      const bool down = registers[0].has(timer_bits::kDown);
      ends = !registers[0].has(timer_bits::kCapture) && edges_to_end(wide(), down) == 1;
      set_wide(down ? wide() - 1 : wide() + 1);
      lower.wrapped = ends;
      if (ends) lower.shows = kExtraShowsOfCascade;
      break;
  }
  if (registers[1].has(timer_bits::kLoad)) load(1, registers[1].start);
  return ends;
}

Cycles TimerCounters::plan(const TimerRegisterPair& registers, Mode mode) {
  counters_[0].step = counters_[1].step = 0;
  wide_step_ = 0;
  const Motion first = motion(0, registers[0], mode, true);
  if (mode.cascade) return plan_wide(first, registers);
  const Motion second = motion_of_second(first, registers, mode);
  return std::min(plan_alone(0, first, registers[0]), plan_alone(1, second, registers[1]));
}

// The counter follows TLR: after one edge nothing moves.
Cycles TimerCounters::plan_load(unsigned timer, const TimerRegisters& registers) const {
  const Counter& counter = counters_[timer];
  return counter.count == registers.start && !counter.wrapped ? kNever : at_ + Cycles{1};
}

Cycles TimerCounters::plan_alone(unsigned timer, Motion motion, const TimerRegisters& registers) {
  Counter& counter = counters_[timer];
  if (motion == Motion::kStands) return kNever;
  if (motion == Motion::kLoads) return plan_load(timer, registers);
  if (motion != Motion::kCounts) return at_ + Cycles{1};
  const bool down = registers.has(timer_bits::kDown);
  counter.step = down ? kOneDown : 1;
  if (registers.has(timer_bits::kCapture)) return kNever;
  return after(at_, edges_to_end(counter.count, down));
}

Cycles TimerCounters::plan_wide(Motion motion, const TimerRegisterPair& registers) {
  Cycles wake = kNever;
  if (registers[1].has(timer_bits::kLoad)) wake = plan_load(1, registers[1]);
  if (motion == Motion::kStands) return wake;
  if (motion == Motion::kLoads) return std::min(wake, plan_load(0, registers[0]));
  // An upper half that loads while the lower one counts is seldom: every edge is computed.
  if (motion != Motion::kCounts || registers[1].has(timer_bits::kLoad)) return at_ + Cycles{1};
  const bool down = registers[0].has(timer_bits::kDown);
  wide_step_ = down ? ~std::uint64_t{0} : 1;
  if (registers[0].has(timer_bits::kCapture)) return kNever;
  return after(at_, edges_to_end(wide(), down));
}

}  // namespace armature::cosim::model
