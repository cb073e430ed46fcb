// Whole ticks of the plant. The same steps with the same arithmetic as with edges, so the same bits.
#include <algorithm>
#include <cstdlib>
#include <span>
#include <utility>

#include "cosim/plant/plant.hpp"

namespace armature::cosim {
namespace {

// A way of at least so many counts in a step is one way: rounding to subcounts cannot turn it.
constexpr double kOneWay = 0x1.0p-20;

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
      ticks_->quiet[axis] = {.min = Counts{1}, .max = Counts{0}};
    }
  }
  PlantTicks::State& begin = ticks_->begin;
  if (begin.drives.empty()) {
    for (const ServoDrive& drive : drives_) begin.drives.push_back(drive.state());
  } else {
    for (std::size_t axis = 0; axis < kAxes; ++axis) begin.drives[axis] = drives_[axis].state();
  }
  begin.shafts = shafts_;
  mechanics_->keep();
  begin.moving = moving_;
  for (std::size_t axis = 0; axis < kAxes; ++axis) begin.motions[axis] = encoders_[axis].motions();
  ticks_->index.fill(std::nullopt);
  if (finishes_step(tick.begins, spacing) && run_steps(tick, spacing)) {
    const Cycles until = tick.ends - Cycles{2};
    for (std::size_t axis = 0; axis < kAxes; ++axis) ticks_->counts[axis] = encoders_[axis].count_after(until);
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
  if ((tick.ends - tick.begins).value() > kPlantStep.value() * static_cast<std::int64_t>(TickSteps::kMaxSteps))
    return false;
  if (drop_out_ && (drop_out_->is_open() || drop_out_->opens_at() <= tick.ends)) return false;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const ServoDrive& drive = drives_[axis];
    if (drive.alarm() || !drive.takes(tick.axes[axis]) || !drive.input().accepts(tick.axes[axis])) return false;
  }
  return !violation_;
}

void Plant::revert_tick() {
  for (std::size_t axis = 0; axis < kAxes; ++axis) drives_[axis].set_state(ticks_->begin.drives[axis]);
  shafts_ = ticks_->begin.shafts;
  mechanics_->take_back();
  moving_ = ticks_->begin.moving;
  for (std::size_t axis = 0; axis < kAxes; ++axis) encoders_[axis].set_motions(ticks_->begin.motions[axis]);
  if (ticks_->first) ticks_.reset();
}

bool Plant::run_steps(const TickPulses& tick, Cycles spacing) {
  TickSteps& steps = ticks_->steps;
  steps.run(tick, drives_, moving_, *mechanics_, shafts_);
  bool fine = mechanics_->overloaded() == 0;
  for_each_bit(steps.moved(),
               [&](std::size_t axis) { fine = fine && has_levels_of_inputs(axis) && follow_steps(axis, spacing); });
  if (!fine) return false;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::int32_t pulses = tick.axes[axis].count;
    if (pulses == 0 && !has_bit(steps.moved(), axis)) continue;
    ServoDrive& drive = drives_[axis];
    const Shaft shaft = shafts_[axis];
    drive.skip(pulses, has_bit(inputs_.in_position, axis), drive.enabled() ? !shaft.at_rest() : !shaft.stands());
    set_bit(moving_, axis, !drive.idle());
  }
  return true;
}

// In all steps of the tick.
bool Plant::has_levels_of_inputs(std::size_t axis) const {
  const ServoDrive& drive = drives_[axis];
  const bool in_position = has_bit(inputs_.in_position, axis);
  if (has_bit(inputs_.drive_alarm, axis)) return false;
  if (!drive.enabled()) return !in_position;
  const TickSteps::Extremes& seen = ticks_->steps.extremes();
  if (seen.largest_error[axis] > drive.alarm_error()) return false;
  return in_position ? seen.largest_error[axis] < ServoDrive::kInPositionCounts
                     : seen.smallest_error[axis] >= ServoDrive::kInPositionCounts;
}

// Moves the encoder through the steps of the tick. Returns whether only lines may change.
bool Plant::follow_steps(std::size_t axis, Cycles spacing) {
  const TickSteps& steps = ticks_->steps;
  const double least = steps.extremes().least_way[axis], most = steps.extremes().most_way[axis];
  const bool forward = least >= kOneWay;
  if (!forward && most > -kOneWay) return follow_each_step(axis, spacing);
  const double fastest = (forward ? most : -least) + kOneWay;
  if (fastest * static_cast<double>(spacing.value() + 1) > static_cast<double>(kPlantStep.value())) {
    return follow_each_step(axis, spacing);
  }
  if ((forward ? +1 : -1) != ticks_->direction[axis]) return follow_each_step(axis, spacing);
  return follow_one_way(axis);
}

bool Plant::follow_each_step(std::size_t axis, Cycles spacing) {
  IncrementalEncoder& encoder = encoders_[axis];
  const TickSteps& steps = ticks_->steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    encoder.move_without_edges(steps.began(i), kPlantStep, steps.position(i, axis));
    if (!shows_no_more_than_lines(axis, nearest_count(encoder.start()), steps.began(i), spacing)) return false;
  }
  return true;
}

// The same for a motion in the direction of the latest count, which is not too fast: only its last steps are looked at.
bool Plant::follow_one_way(std::size_t axis) {
  TickSteps& steps = ticks_->steps;
  IncrementalEncoder::Motions& motions = encoders_[axis].motions_to_change();
  const std::span<const Subcounts> way = steps.positions_from(motions.present.target, axis);
  const auto step = [&](std::size_t end) {
    return IncrementalEncoder::Motion{steps.began(end - 1), kPlantStep, way[end - 1], way[end]};
  };
  const std::size_t last = steps.size();
  motions.before = last == 1 ? motions.present : step(last - 1);
  motions.present = step(last);
  const Counts from = nearest_count(way.front()), to = nearest_count(way.back());
  if (from == to) return true;
  const CountRange& quiet = ticks_->quiet[axis];
  if (!quiet.has(from) || !quiet.has(to)) {
    if (!switches_[axis].are_steady(from, to) || !passes_index(axis, from, to)) return false;
    ticks_->quiet[axis] = quiet_around(axis, to);
  }

  std::size_t counted = last;
  while (nearest_count(way[counted - 1]) == to) --counted;
  ticks_->changed_in[axis] = steps.began(counted - 1);
  motions.counted_before = motions.counted;
  motions.counted = step(counted);
  const Counts before = nearest_count(way[counted - 1]);
  if (before == from) return true;
  std::size_t counted_before = counted - 1;
  while (nearest_count(way[counted_before - 1]) == before) --counted_before;
  motions.counted_before = step(counted_before);
  return true;
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

  return passes_index(axis, from, to);
}

// The counts around this one between which no switch changes and no index comes; none where the index is.
CountRange Plant::quiet_around(std::size_t axis, Counts count) const {
  const std::int64_t turn = encoders_[axis].counts_per_rev();
  const std::int64_t remainder = count.value() % turn, since = remainder < 0 ? remainder + turn : remainder;
  const CountRange steady = switches_[axis].steady_around(count);
  return {.min = std::max(steady.min, count - Counts{since - 1}),
          .max = std::min(steady.max, count + Counts{turn - since - 1})};
}

// The index comes with a multiple of a revolution that is reached. Returns false if it comes again in the tick.
bool Plant::passes_index(std::size_t axis, Counts from, Counts to) {
  if (from == to) return true;
  const std::int64_t turn = encoders_[axis].counts_per_rev();
  const int direction = to > from ? +1 : -1;
  const std::int64_t ahead = to.value() * direction % turn;  // counts since the latest multiple, in the direction
  const std::int64_t since = ahead < 0 ? ahead + turn : ahead;
  const std::int64_t way = std::abs((to - from).value());
  if (since >= way) return true;
  if (ticks_->index[axis] || since + turn < way) return false;
  ticks_->index[axis] = to - Counts{direction * since};
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
