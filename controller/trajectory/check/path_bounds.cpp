#include "controller/trajectory/check/path_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"
#include "controller/kinematics/turns.hpp"
#include "controller/trajectory/cartesian/path_corners.hpp"

namespace armature {
namespace {

// A way that takes less time is not worth its samples: a first one, and half of another one.
constexpr double kFewTicks = 64.0, kFewTicksOfHalf = 24.0;
// Between the places of a sample, at the largest speed on its way and of that way: rounding and the error of its
// derivatives are both small.
constexpr double kStepTicks = 0.25, kStepOfWay = 1e-3;
constexpr double kNoWay = 1e-9;  // share of a length
constexpr double kLongestArc_rad = 0.25 * kTurn_rad;

// Beyond the reach the limits of a law may be no numbers.
bool is_motion(const TimeTable& table) {
  for (std::size_t i = 0; i + 1 < table.size(); ++i) {
    const TimeTable::Point &a = table[i], &b = table[i + 1];
    if (!(b.t_s >= a.t_s && std::isfinite(a.s + a.speed + a.jerk + b.t_s))) return false;
  }
  return true;
}

// Where a path passes a singularity so that a side of the arm changes, joints turn close to it: the closer it passes,
// the less, but in less time. Samples do not show it.
bool on_one_side(const Configuration& first, const Configuration& middle, const Configuration& last) {
  if (first.shoulder == ShoulderSide::kNearest || first.elbow == ElbowSide::kNearest) return false;
  return first == middle && middle == last;
}

}  // namespace

double PathBounds::ticks() const noexcept {
  return t_s_ / kTickSeconds;
}

void PathBounds::begin(const CartesianPlan& plan) noexcept {
  t_s_ = 0.0;
  point_ = 0;
  while (point_ + 2 < plan.table.size() && plan.table[point_ + 1].t_s <= 0.0) ++point_;
  ahead_count_ = stale_ = span_ = span_count_ = 0;
  at_sample_ = false;
  begin_interval(plan);
  over_ = !is_motion(plan.table);
  last_ = {};
  last_.joints = plan.start;
  const double s = plan.table.position(0.0);
  segment_ = segment_on_path(plan, s);
  in_corner_ = false;
  const CartesianSegment& segment = plan.segments[segment_];
  if (segment_ > 0 && s - segment.from < plan.segments[segment_ - 1].corner) {
    --segment_;
    in_corner_ = true;
  } else if (segment.corner > 0.0 && segment.from + segment.length - s <= segment.corner) {
    in_corner_ = true;
  }
  begin_part(plan, s);
}

// What the law does before the present interval of its table is known, or does not matter.
void PathBounds::begin_interval(const CartesianPlan& plan) noexcept {
  before_ = motion_after(plan.table, point_);
  joined_ = false;
}

bool PathBounds::next_part(const CartesianPlan& plan) noexcept {
  if (!in_corner_ && plan.segments[segment_].corner > 0.0) {
    in_corner_ = true;
  } else {
    do {
      if (++segment_ >= plan.count) return false;
    } while (plan.segments[segment_].length == 0.0);
    in_corner_ = false;
  }
  begin_part(plan, 0.0);
  return true;
}

// The search begins at the start of the part, or at `from` if that is behind.
void PathBounds::begin_part(const CartesianPlan& plan, double from) noexcept {
  const CartesianSegment& segment = plan.segments[segment_];
  const double end = segment.from + segment.length;
  if (in_corner_) {
    part_ = {end - segment.corner, end + segment.corner};
  } else {
    const double corner_before = segment_ > 0 ? plan.segments[segment_ - 1].corner : 0.0;
    part_ = {segment.from + corner_before, end - segment.corner};
  }
  last_.s = std::max(from, part_.from);
  last_.found = false;
}

// Where the first way from a place of the part ends.
double PathBounds::first_end(const CartesianPlan& plan, double from) const noexcept {
  const CartesianSegment& segment = plan.segments[segment_];
  const double middle = segment.from + segment.length;
  // Both halves of a corner have their own limits.
  if (in_corner_) return from > part_.from && from < middle ? middle : part_.to;
  const PositionPath& path = segment.path;
  double end = part_.to;
  if (path.shape == PositionPath::Shape::kArc) {
    end = std::min(end, from + segment.length * kLongestArc_rad / std::max(path.angle_rad, kLongestArc_rad));
  } else if (path.shape == PositionPath::Shape::kSpline) {
    const double per_mm = segment.length / path.length_mm;
    for (std::size_t i = 1; i < path.spline->points_mm().size(); ++i) {
      const double s = segment.from + path.spline->length_to_mm(i) * per_mm;
      if (s > from + kNoWay * segment.length) return std::min(end, s);
    }
  }
  return part_.to - end < kNoWay * segment.length ? part_.to : end;
}

// A segment that must end in a configuration is checked at its end, which is in the middle of its corner.
bool PathBounds::may_bound(const CartesianPlan& plan) const noexcept {
  return !in_corner_ || requested_parts(plan.segments[segment_].configuration) == 0;
}

PathBounds::Passage PathBounds::passage(const CartesianPlan& plan, double s) const noexcept {
  const TimeTable& table = plan.table;
  Passage result{.t_s = t_s_};
  std::size_t i = point_;
  for (; i + 1 < table.size(); ++i) {
    const TimeTable::Point &a = table[i], &b = table[i + 1];
    const double length_s = b.t_s - a.t_s;
    result.speed = std::max({result.speed, a.speed, b.speed + std::fabs(a.jerk) * length_s * length_s / 8.0});
    result.t_s = b.t_s;
    if (b.s < s) continue;
    result.t_s = a.t_s + time_at(motion_after(table, i), s, length_s);
    break;
  }
  result.t_s = std::max(result.t_s, t_s_);
  return result;
}

SpanSample PathBounds::sample(const CartesianPlan& plan, double s, double speed, double way,
                              const JointAngles& near) noexcept {
  const double delta =
      std::min(std::max(kStepTicks * kTickSeconds * speed, kStepOfWay * way), (part_.to - part_.from) / 16.0);
  SpanSample result = sample_at(plan, arm_, part_, s, delta, near);
  inverses_ += result.inverses;
  for (std::size_t i = 0; i < plan.bends.count; ++i) {
    const WristBend& bend = plan.bends.bends[i];
    if (s > bend.from - 4.0 * delta && s < bend.to + 4.0 * delta) result.found = false;
  }
  return result;
}

PathBounds::Found PathBounds::unknown_until(const CartesianPlan& plan, double t_s) noexcept {
  t_s_ = t_s;
  while (point_ + 2 < plan.table.size() && plan.table[point_ + 1].t_s <= t_s_) ++point_;
  begin_interval(plan);
  return Found::kUnknown;
}

PathBounds::Found PathBounds::step(const CartesianPlan& plan) noexcept {
  inverses_ = 0;
  at_sample_ = false;
  if (over_) return Found::kEnd;
  return span_ < span_count_ ? check_interval(plan) : search(plan);
}

void PathBounds::continue_from(const JointAngles& joints) noexcept {
  if (span_ < span_count_) return;
  last_.joints = joints;
  last_.found = false;
  stale_ = ahead_count_;
}

PathBounds::Found PathBounds::search(const CartesianPlan& plan) noexcept {
  if (ahead_count_ > 0) return check_way(plan);
  const bool at_end = part_.to - last_.s <= kNoWay * plan.segments[segment_].length;
  return at_end ? end_part(plan) : begin_way(plan);
}

// Where segments meet without a corner and the motion continues, and where a configuration is requested, the set-points
// around are checked.
PathBounds::Found PathBounds::end_part(const CartesianPlan& plan) noexcept {
  const bool breaks = !in_corner_ && plan.segments[segment_].corner == 0.0;
  const std::size_t before = segment_;
  over_ = !next_part(plan);
  if (over_) return Found::kEnd;
  if (!breaks) return Found::kSearching;
  bool checked = joint_after(plan, before) == PathJoint::kSmooth;
  for (std::size_t i = before; i < segment_; ++i) {
    checked = checked || requested_parts(plan.segments[i].configuration) != 0;
  }
  return checked ? unknown_until(plan, t_s_) : Found::kSearching;
}

PathBounds::Found PathBounds::begin_way(const CartesianPlan& plan) noexcept {
  const double end = first_end(plan, last_.s);
  const Passage there = passage(plan, end);
  if (there.t_s - t_s_ < kFewTicks * kTickSeconds || !may_bound(plan)) {
    last_.s = end;
    last_.found = false;
    return unknown_until(plan, there.t_s);
  }
  const double way = end - last_.s;
  last_ = sample(plan, last_.s, there.speed, way, last_.joints);
  ahead_[ahead_count_++] = sample(plan, end, there.speed, way, last_.joints);
  return Found::kSearching;
}

// Makes two spans of the nearest way, or halves it.
PathBounds::Found PathBounds::check_way(const CartesianPlan& plan) noexcept {
  SpanSample& end = ahead_[ahead_count_ - 1];
  const Passage there = passage(plan, end.s);
  const bool on_bend = plan.bends.at(last_.s) != nullptr && plan.bends.at(last_.s) == plan.bends.at(end.s);
  if (there.t_s - t_s_ < kFewTicksOfHalf * kTickSeconds || ahead_count_ == kDepth || on_bend) {
    last_ = end;
    --ahead_count_;
    return unknown_until(plan, there.t_s);
  }
  const double way = end.s - last_.s;
  if (ahead_count_ <= stale_) {
    last_ = sample(plan, last_.s, there.speed, way, last_.joints);
    end = sample(plan, end.s, there.speed, way, last_.joints);
    stale_ = ahead_count_ - 1;
    return Found::kSearching;
  }
  const SpanSample middle = sample(plan, 0.5 * (last_.s + end.s), there.speed, way, last_.joints);
  const bool found = last_.found && middle.found && end.found;
  if (found && on_one_side(last_.sides, middle.sides, end.sides)) {
    const SpanMisfit off = misfit(last_, middle, end);
    if (check_.fits(plan.segments[segment_], off, there.speed) &&
        (!in_corner_ || check_.fits(plan.segments[segment_ + 1], off, there.speed))) {
      add_spans(plan, middle, end, off);
      last_ = end;
      --ahead_count_;
      return Found::kSearching;
    }
  }
  ahead_[ahead_count_++] = middle;
  return Found::kSearching;
}

void PathBounds::add_spans(const CartesianPlan& plan, const SpanSample& middle, const SpanSample& end,
                           const SpanMisfit& misfit) noexcept {
  spans_ = {span_between(last_, middle, misfit), span_between(middle, end, misfit)};
  span_ = 0;
  span_count_ = spans_.size();
  const CartesianSegment& segment = plan.segments[segment_];
  for (PathSpan& span : spans_) {
    const bool second_half = in_corner_ && 0.5 * (span.from + span.to) > segment.from + segment.length;
    span.segment = segment_ + (second_half ? 1 : 0);
    span.exact_tool = !in_corner_ && segment.path.shape != PositionPath::Shape::kSpline;
  }
  longest_s_ = seconds(plan.duration);
}

}  // namespace armature
