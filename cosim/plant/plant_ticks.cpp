// Whole ticks of the plant. The same steps with the same arithmetic as with edges, so the same bits.
#include <algorithm>
#include <cstdlib>
#include <utility>

#include "cosim/plant/plant.hpp"

namespace armature::cosim {
namespace {

constexpr Cycles grid_from(Cycles at) {
  const std::int64_t step = kPlantStep.value();
  return Cycles{(at.value() + step - 1) / step * step};
}

}  // namespace

bool Plant::begin_tick(const TickPulses& tick, Cycles spacing) {
  if (!can_leave_out(tick)) return false;
  if (ticks_) {
    ticks_->first = false;
  } else {
    ticks_.emplace();
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const Subcounts moved = encoders_[axis].target() - encoders_[axis].start();
      ticks_->direction[axis] = moved < Subcounts{} ? -1 : +1;
      ticks_->changed_in[axis] = grid_from(tick.begins) - kPlantStep;
    }
  }
  PlantTicks::State& begin = ticks_->begin;
  begin.drives = drives_;
  begin.shafts = shafts_;
  begin.moving = moving_;
  for (std::size_t axis = 0; axis < kAxes; ++axis) begin.motions[axis] = encoders_[axis].motions();
  ticks_->index.fill(std::nullopt);
  if (finishes_step(tick.begins, spacing) && run_steps(tick, spacing)) {
    ticks_->counted_until = tick.ends - Cycles{2};
    return true;
  }
  revert_tick();
  return false;
}

// The rest of the step that has begun before the first tick.
bool Plant::finishes_step(Cycles now, Cycles spacing) {
  bool fine = true;
  for (std::size_t axis = 0; axis < kAxes && ticks_->first; ++axis) {
    fine = fine && shows_no_more_than_lines(axis, encoders_[axis].count(), grid_from(now) - kPlantStep, spacing);
  }
  return fine;
}

bool Plant::can_leave_out(const TickPulses& tick) const {
  if (!ticks_ && next_step_ != kNever && next_step_ != grid_from(tick.begins)) return false;
  if (drop_out_ && (drop_out_->is_open() || drop_out_->opens_at() <= tick.ends)) return false;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const ServoDrive& drive = drives_[axis];
    if (drive.alarm() || !drive.takes(tick.axes[axis]) || !drive.input().accepts(tick.axes[axis])) return false;
  }
  return !violation_;
}

void Plant::revert_tick() {
  drives_ = ticks_->begin.drives;
  shafts_ = ticks_->begin.shafts;
  moving_ = ticks_->begin.moving;
  for (std::size_t axis = 0; axis < kAxes; ++axis) encoders_[axis].set_motions(ticks_->begin.motions[axis]);
  if (ticks_->first) ticks_.reset();
}

// The steps that begin in the tick. Pulses after the last one belong to the first step of the next tick.
bool Plant::run_steps(const TickPulses& tick, Cycles spacing) {
  PerAxis<std::int32_t> taken{};
  for (Cycles now = grid_from(tick.begins); now < tick.ends; now += kPlantStep) {
    const bool rested = moving_ == 0;
    const bool before = rested && take_pulses(tick, now - Cycles{1}, taken);
    take_pulses(tick, now, taken);
    // A pulse at the very cycle of the step ends the rest. The first step then comes later.
    if (moving_ == 0 || (rested && !before)) continue;
    if (!step_without_edges(now, spacing)) return false;
  }
  take_pulses(tick, tick.ends - Cycles{1}, taken);
  return true;
}

// Those that rise up to the cycle `until`. Returns whether there is one.
bool Plant::take_pulses(const TickPulses& tick, Cycles until, PerAxis<std::int32_t>& taken) {
  bool any = false;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const AxisPulses& pulses = tick.axes[axis];
    if (pulses.count == 0) continue;
    const std::int32_t rises = pulses.rises_until(until);
    const std::int32_t more = rises - std::exchange(taken[axis], rises);
    if (more == 0) continue;
    drives_[axis].take(pulses.count < 0 ? -more : more, shafts_[axis]);
    moving_ |= bit_of(axis);
    any = true;
  }
  return any;
}

bool Plant::step_without_edges(Cycles now, Cycles spacing) {
  bool fine = true;
  step_mechanics([&](std::size_t axis, Subcounts position) {
    encoders_[axis].move_without_edges(now, kPlantStep, position);
    const Counts from = nearest_count(encoders_[axis].start());
    fine = fine && has_levels_of_inputs(axis) && shows_no_more_than_lines(axis, from, now, spacing);
  });
  return fine;
}

bool Plant::has_levels_of_inputs(std::size_t axis) const {
  return drives_[axis].alarm() == has_bit(inputs_.drive_alarm, axis) &&
         drives_[axis].in_position() == has_bit(inputs_.in_position, axis);
}

// From the count `from` to the end of the step that begins now, or that has begun before.
bool Plant::shows_no_more_than_lines(std::size_t axis, Counts from, Cycles now, Cycles spacing) {
  const IncrementalEncoder& encoder = encoders_[axis];
  const Counts to = encoder.target_count();
  if (from == to) return true;

  const std::int64_t distance = std::abs((encoder.target() - encoder.start()).value());
  if (distance * (spacing.value() + 1) > kSubcountsPerCount * kPlantStep.value()) return false;
  const int direction = to > from ? +1 : -1;
  const bool turned = direction != std::exchange(ticks_->direction[axis], direction);
  const Cycles before = std::exchange(ticks_->changed_in[axis], now);
  if (turned && now - before <= kPlantStep) return false;
  if (!switches_[axis].are_steady(from, to)) return false;

  // The index comes with the first multiple of a revolution that is reached.
  const std::int64_t turn = encoder.counts_per_rev();
  const std::int64_t ahead = to.value() * direction % turn;  // counts since the latest multiple, in the direction
  const std::int64_t since = ahead < 0 ? ahead + turn : ahead;
  if (since < std::abs((to - from).value())) {
    if (ticks_->index[axis]) return false;
    ticks_->index[axis] = to - Counts{direction * since};
  }
  return true;
}

CountRange Plant::counts_in_tick(std::size_t axis, Cycles from) const {
  const Counts first = encoders_[axis].count_after(from), last = motor_counts(axis);
  return {.min = std::min(first, last), .max = std::max(first, last)};
}

LineHistory Plant::line_history(Cycles from, Cycles now) const {
  struct Edge {
    Cycles at;
    std::size_t axis;
    Counts count;  // after it
  };
  std::vector<Edge> edges;
  LineHistory history{.from = from};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const IncrementalEncoder& encoder = encoders_[axis];
    Counts count = encoder.count();
    if (ticks_) {
      count = encoder.count_after(from);
      history.counted[axis] = encoder.edge_before(from).value_or(Cycles{});
      history.counts[axis] = count;
      for (Cycles at = from + Cycles{1}; at < now; at += Cycles{1}) {
        const Counts next = encoder.count_after(at);
        if (next != count) edges.push_back({at, axis, next});
        count = next;
      }
    } else {
      encoder.edges_since(from, [&](Cycles at, Counts before) {
        edges.push_back({at, axis, count});
        count = before;
      });
      history.counts[axis] = count;
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.at < b.at; });
  PerAxis<Counts> counts = history.counts;
  const auto lines = [&] {
    EncoderLines levels;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      set_bit(levels.a, axis, encoders_[axis].a(counts[axis]));
      set_bit(levels.b, axis, encoders_[axis].b(counts[axis]));
      set_bit(levels.z, axis, encoders_[axis].z(counts[axis]));
    }
    return levels;
  };
  history.lines = lines();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    counts[edges[i].axis] = edges[i].count;
    if (i + 1 == edges.size() || edges[i + 1].at != edges[i].at) history.changes.push_back({edges[i].at, lines()});
  }
  return history;
}

void Plant::resume_edges(Cycles now, const SocOutputs& out, const PerAxis<Cycles>& changed,
                         const PerAxis<Cycles>& turned) {
  ticks_.reset();
  seen_.step = out.step;
  seen_.dir = out.dir;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    drives_[axis].resume_input(has_bit(out.step, axis), has_bit(out.dir, axis), changed[axis], turned[axis]);
    encoders_[axis].resume(now);
    next_edge_[axis] = encoders_[axis].next_edge();
    show_count(axis);
  }
  next_step_ = moving_ != 0 ? grid_from(now + Cycles{1}) : kNever;
  find_next_event();
}

}  // namespace armature::cosim
