// The part of PathBounds that checks the intervals of the law on a span.
#include <algorithm>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/check/path_bounds.hpp"

namespace armature {
namespace {

constexpr double kSameEnd = 1e-9;  // share of a span

}  // namespace

PathBounds::Found PathBounds::check_interval(const CartesianPlan& plan) noexcept {
  inverses_ = 1;
  const PathSpan& span = spans_[span_];
  const CartesianSegment& segment = plan.segments[span.segment];
  const TimeTable& table = plan.table;
  const TimeTable::Point &a = table[point_], &b = table[point_ + 1];
  const double length_s = b.t_s - a.t_s;
  const SpanMotion piece = motion_after(table, point_);
  if (!joined_) {
    joined_ = true;
    break_s_ = -1.0;
    // The table counts from the nearer end of its interval.
    const double middle_s = a.t_s + 0.5 * length_s;
    SpanMotion front = piece.after(length_s), back = front;
    back.s = b.s;
    if (middle_s > t_s_ && !check_.joins(segment, span, front, back)) break_s_ = middle_s;
    if (!check_.joins(segment, span, before_, piece)) return unknown_until(plan, t_s_);
  }
  if (t_s_ == break_s_) {
    break_s_ = -1.0;
    return Found::kUnknown;
  }
  const bool passes = b.s > span.to + kSameEnd * (span.to - span.from);
  double end_s = passes ? a.t_s + time_at(piece, span.to, length_s) : b.t_s;
  const bool breaks = break_s_ > t_s_ && break_s_ < end_s;
  if (breaks) end_s = break_s_;
  const double left_s = std::max(end_s - t_s_, 0.0), tried_s = std::min(left_s, longest_s_);
  const SpanMotion from = piece.after(t_s_ - a.t_s);
  const SpanCheck::Result result = check_.check(segment, span, from, tried_s);
  const bool few = tried_s < kFewestTicks * kTickSeconds;
  const bool exceeded = !result.kept && result.stretch > 1.0 && tried_s >= kLongExcessTicks * kTickSeconds;
  if (!result.kept && !few && !exceeded) {
    longest_s_ = 0.5 * tried_s;
    return Found::kSearching;
  }
  longest_s_ = 2.0 * tried_s;
  jerk_share_ = result.jerk_share;
  excess_ = {.stretch = result.stretch, .axis = result.axis, .from_tick = ticks()};
  if (tried_s < left_s) {
    t_s_ += tried_s;
  } else if (breaks) {
    t_s_ = end_s;
  } else {
    end_interval(plan, end_s, !passes);
  }
  excess_.to_tick = ticks();
  return result.kept ? Found::kKept : exceeded ? Found::kExceeded : Found::kUnknown;
}

// The interval is known up to its end in the table, or up to the end of the span.
void PathBounds::end_interval(const CartesianPlan& plan, double end_s, bool at_end_of_table) noexcept {
  const PathSpan& span = spans_[span_];
  const TimeTable& table = plan.table;
  t_s_ = end_s;
  longest_s_ = seconds(plan.duration);
  bool next_span = true;
  if (at_end_of_table) {
    const TimeTable::Point &a = table[point_], &b = table[point_ + 1];
    next_span = b.s >= span.to - kSameEnd * (span.to - span.from);
    before_ = motion_after(table, point_).after(b.t_s - a.t_s);
    before_.s = b.s;
    joined_ = false;
    if (point_ + 2 < table.size()) {
      ++point_;
    } else {
      span_ = span_count_;  // the end of the plan
    }
  }
  if (next_span) at_sample_ = ++span_ == span_count_;
}

}  // namespace armature
