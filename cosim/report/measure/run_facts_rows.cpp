// What the rows of a run add to its facts.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "controller/base/angle_units.hpp"
#include "controller/base/rounding.hpp"
#include "controller/base/timebase.hpp"
#include "cosim/report/measure/run_facts.hpp"

namespace armature::cosim {
namespace {

// Keeps the largest value so far, and the place where it was reached first: here().
template <class T, class Place, class Here>
void raise(T& largest, Place& at, T value, Here here) {
  if (!(value > largest)) return;
  largest = value;
  at = here();
}

RunPlace place_of(const TraceRow& row, std::size_t axis) {
  return {.tick = row.tick, .at = Cycles{row.cycle}, .axis = static_cast<std::uint8_t>(axis + 1)};
}

}  // namespace

void RunFactsCollector::add(const TraceRow& row) {
  const RunPlace here{.tick = row.tick, .at = Cycles{row.cycle}};
  facts_.stops.row(here);
  const RowNews news = add_axes(row);
  if (news.reference_moved) {
    facts_.moved = true;
    reference_moved_tick_ = row.tick;
    outside_tick_ = row.tick - 1;
  }
  if (news.outside != 0) {
    outside_tick_ = row.tick;
    facts_.last_outside_at = here;
    facts_.last_outside_at->axis = static_cast<std::uint8_t>(news.outside);
  }
  stopped_ = stopped_ || row.stopped;
  if (row.telemetry.state == MotionState::kHolding && row.telemetry.rate == 0) facts_.held_s += kTickSeconds;
  if (row.telemetry.underruns > 0 && !facts_.first_underrun_at) {
    facts_.first_underrun_at = here;
  }
  facts_.underruns = row.telemetry.underruns;
  facts_.solved_poses = row.telemetry.solved_poses;
  facts_.solver_difference_pulses = row.telemetry.solver_difference_pulses;
  if (row.tick > 0) add_instructions(row);  // the first one ends the start-up
  facts_.last_trigger_at = here;
  if (!facts_.first_trigger_at) facts_.first_trigger_at = here;
  ++facts_.ticks;
  if (row.load_lead_deg) add_load_lead(*row.load_lead_deg);
  path_error_.add(row);
  if (tracking_error_) tracking_error_->add(row);
  injections_.add(row);
  tool_before_.reset();
  if (last_.tool_point) tool_before_ = last_.tool_point->reference_mm;
  last_ = row;
}

void RunFactsCollector::add_load_lead(const PerAxis<double>& lead_deg) {
  if (!least_lead_deg_) least_lead_deg_ = most_lead_deg_ = lead_deg;
  for (std::size_t i = 0; i < kAxes; ++i) {
    (*least_lead_deg_)[i] = std::min((*least_lead_deg_)[i], lead_deg[i]);
    (*most_lead_deg_)[i] = std::max((*most_lead_deg_)[i], lead_deg[i]);
  }
}

void RunFactsCollector::add_instructions(const TraceRow& row) {
  const std::int64_t instructions = row.load[0].instructions;
  std::int64_t& most = facts_.most_instructions.at(static_cast<std::size_t>(row.telemetry.state));
  if (instructions > std::ranges::max(facts_.most_instructions)) {
    facts_.most_instructions_at = {.tick = row.tick, .at = Cycles{row.cycle}};
  }
  most = std::max(most, instructions);
}

// The axes of a row. Most values of most rows change no fact, so places are made only where one changes.
RunFactsCollector::RowNews RunFactsCollector::add_axes(const TraceRow& row) {
  const Telemetry& now = row.telemetry;
  const Telemetry& before = last_.telemetry;
  // Entering and leaving Fault sets the reference to the position of the arm at once, and so does the end of homing.
  const bool in_fault = now.state == MotionState::kFault || before.state == MotionState::kFault;
  const unsigned located = now.referenced & ~unsigned{before.referenced};
  const bool first = facts_.ticks == 0;
  RowNews news;
  for (std::size_t i = 0; i < kAxes; ++i) {
    Axis& axis = axes_[i];
    const auto here = [&] { return place_of(row, i); };
    const bool faulty = in_fault || ((located >> i) & 1) != 0;
    const std::int64_t encoder = now.encoder[i].value();
    const double step_rad = (now.reference[i] - before.reference[i]).value();
    if (step_rad != 0 && !first) {
      news.reference_moved = true;
      add_step(row, i, step_rad, faulty);
    }
    raise(axis.farthest, axis.farthest_at, axis.direction * encoder, here);
    if (is_outside(now, i)) news.outside = i + 1;

    if (!faulty) {
      const double error_deg = (now.reference[i].value() - now.actual[i].value()) * kDegPerRad;
      raise(facts_.worst_following_error_deg[i], facts_.worst_following_error_at[i], std::fabs(error_deg), here);
    }
    // The counts that the last row commands beyond its pins are meant for the tick that this row ends.
    if (!faulty && !first) {
      const std::int64_t residual = before.commanded[i].value() - row.pin_pulses[i];
      facts_.inexact_ticks[i] += residual != 0 ? 1 : 0;
      raise(facts_.max_residual_pulses, facts_.max_residual_at, std::abs(residual), here);
    }
    const std::int64_t emitted = row.pin_pulses[i] - last_.pin_pulses[i];
    raise(facts_.peak_pulses_per_tick, facts_.peak_pulses_at, std::abs(emitted), here);
    raise(facts_.max_correction_pulses, facts_.max_correction_at, std::abs(now.correction[i].value()), here);
  }
  return news;
}

// The reference has moved.
void RunFactsCollector::add_step(const TraceRow& row, std::size_t i, double step_rad, bool faulty) {
  Axis& axis = axes_[i];
  const auto here = [&] { return place_of(row, i); };
  const std::int64_t direction = (step_rad > 0) == (axis.counts_per_turn > 0) ? 1 : -1;
  if (direction != axis.direction) {
    axis.direction = direction;
    axis.farthest = direction * row.telemetry.encoder[i].value();
    axis.farthest_at = here();
  }
  // A smaller step is no higher speed, and a division costs more than a comparison.
  if (faulty || std::fabs(step_rad) <= axis.largest_step_rad) return;
  axis.largest_step_rad = std::fabs(step_rad);
  raise(facts_.peak_speed_deg_s[i], facts_.peak_speed_at[i], axis.largest_step_rad * kDegPerRad / kTickSeconds, here);
}

// Rounding moves the reference by half a count at most, so most rows need none.
bool RunFactsCollector::is_outside(const Telemetry& telemetry, std::size_t i) const {
  const std::int64_t encoder = telemetry.encoder[i].value();
  const double off = std::fabs(exact_reference(telemetry, i) - static_cast<double>(encoder));
  const auto band = static_cast<double>(facts_.settled_counts);
  if (off <= band || off >= band + 1) return off > band;
  return std::abs(reference_counts(telemetry, i) - encoder) > facts_.settled_counts;
}

double RunFactsCollector::exact_reference(const Telemetry& telemetry, std::size_t i) const {
  return static_cast<double>(telemetry.reference_pulses[i].value()) * axes_[i].counts_per_pulse;
}

std::int64_t RunFactsCollector::reference_counts(const Telemetry& telemetry, std::size_t i) const {
  return round_half_away(exact_reference(telemetry, i));
}

}  // namespace armature::cosim
