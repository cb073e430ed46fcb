#include "controller/trajectory/law/speed_law.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/trajectory/law/law_interval.hpp"

namespace armature {
namespace {

// Squares of speeds that differ by less are equal.
constexpr double kSameSquare = 1e-9;
// A point is not added closer to another than this share of the interval.
constexpr double kClosestPoints = 1e-4;
// A change of the square by at least this share gets a point, even if it happens closer to the end of the interval.
constexpr double kLargeChange = 1e-3;
// One that is closer than this share is a change at the end of the interval, where there is a point.
constexpr double kSamePlace = 1e-9;
constexpr double kHardlySlowed = 0.999;  // share of a limit

}  // namespace

void SpeedLaw::clear(std::size_t most) noexcept {
  first_ = size_ = 0;
  most_ = most;
  start_square_ = 0.0;
  pass_ = Pass::kDone;
}

bool SpeedLaw::append(double s, const LawLimits& limits, bool stops) noexcept {
  if (size_ == most_) return false;
  Point& point = at(size_++);
  point = {};
  point.s = s;
  point.limits = limits;
  point.stops = stops;
  return true;
}

void SpeedLaw::drop_front(std::size_t count) noexcept {
  start_square_ = at(count).square;
  first_ = (first_ + count) % kMaxPoints;
  size_ -= count;
  for (std::size_t i = 0; i < size_; ++i) at(i).slowed = 1.0;
}

void SpeedLaw::split(double s) noexcept {
  const std::size_t before = point_at(s), size = size_;
  if (before + 1 >= size) return;
  const double from = at(before).s, step = at(before + 1).s - from;
  const double first = at(before).square, last = at(before + 1).square;
  add_near(s, kClosestPoints * step);
  if (size_ == size) return;
  at(before + 1).square = first + (s - from) / step * (last - first);
  at(before + 1).added = false;
}

void SpeedLaw::drop_behind(double s) noexcept {
  while (size_ > 0 && (at(size_ - 1).s > s || (at(size_ - 1).s == s && at(size_ - 1).stops))) --size_;
}

std::size_t SpeedLaw::point_at(double s) const noexcept {
  std::size_t low = 0, high = size_;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (at(middle).s <= s ? low : high) = middle;
  }
  return low;
}

void SpeedLaw::add_near(double s, double nearest) noexcept {
  const std::size_t before = point_at(s);
  // Some room is left for the points of the passes.
  if (before + 1 >= size_ || size_ + most_ / 8 > most_) return;
  const Point &a = at(before), &b = at(before + 1);
  if (!(s - a.s > nearest && b.s - s > nearest)) return;
  const Point added = between(a, b, s);
  for (std::size_t i = size_++; i > before + 1; --i) at(i) = at(i - 1);
  at(before + 1) = added;
}

SpeedLaw::Point SpeedLaw::between(const Point& first, const Point& second, double s) noexcept {
  Point result;
  result.s = s;
  result.limits = armature::between(first.limits, second.limits, (s - first.s) / (second.s - first.s));
  result.cap = std::max(first.cap, second.cap);  // beside the region of a cap() there is none
  result.slowed = std::max(first.slowed, second.slowed);
  result.added = true;
  return result;
}

LawLimits SpeedLaw::capped(const Point& point) noexcept {
  LawLimits limits = point.limits;
  limits.most_square = std::min(limits.most_square, point.cap);
  return limits;
}

void SpeedLaw::cap(double from, double to, double square) noexcept {
  const double nearest = kClosestPoints * (to - from);
  for (const double s : {from, to}) add_near(s, nearest);
  for (std::size_t i = point_at(from - nearest); i < size_ && at(i).s <= to + nearest; ++i) {
    if (at(i).s >= from - nearest) at(i).cap = std::min(at(i).cap, square);
  }
}

void SpeedLaw::free() noexcept {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    if (at(i).added) continue;
    at(kept) = at(i);
    at(kept++).cap = std::numeric_limits<double>::infinity();
  }
  size_ = kept;
}

void SpeedLaw::uncap() noexcept {
  for (std::size_t i = 0; i < size_; ++i) at(i).cap = std::numeric_limits<double>::infinity();
}

bool SpeedLaw::ease_start() noexcept {
  bool eased = false;
  double slowest = start_square_;  // that can be reached with the limits
  for (std::size_t i = 0; slowest > 0.0 && !stops(i); ++i) {
    Point& point = at(i);
    if (point.cap < slowest) {
      point.cap = slowest * (1.0 + kSameSquare);
      eased = true;
    }
    const double step = s(i + 1) - s(i);
    if (!(step > 0.0)) continue;
    const double fastest_braking = LawInterval{point.limits, limits(i + 1), step}.accelerations(slowest).low;
    if (!(fastest_braking <= 0.0)) break;  // too fast for the limits themselves
    slowest += 2.0 * step * fastest_braking;
  }
  if (eased) return true;
  std::size_t last = 0;  // the limits there determine the speed at the start
  while (at(last).brakes) ++last;
  while (last + 1 < size_ && at(last + 1).slowed == at(last).slowed) ++last;
  for (std::size_t i = 0; i <= last; ++i) {
    Point& point = at(i);
    if (!(point.slowed < kHardlySlowed)) continue;
    const double half = std::sqrt(point.slowed);
    slow_down(point.limits, 1.0 / half);
    point.slowed = half;
    eased = true;
  }
  return eased;
}

double SpeedLaw::duration_s(std::size_t point) const noexcept {
  return 2.0 * (s(point + 1) - s(point)) / (std::sqrt(square(point)) + std::sqrt(square(point + 1)));
}

double SpeedLaw::accel(std::size_t point) const noexcept {
  return 0.5 * (square(point + 1) - square(point)) / (s(point + 1) - s(point));
}

void SpeedLaw::lower(double from, double to, double share) noexcept {
  const double width = to - from;
  if (width > 0.0) {
    for (const double s : {from - width, from, to, to + width}) add_near(s, 0.5 * width);
  }
  const std::size_t last = point_at(to);
  std::size_t first = point_at(from);
  while (first > 0 && at(first - 1).s == at(first).s) --first;
  for (std::size_t i = first; i <= last || (i < size_ && at(i).s - to < 0.5 * width); ++i) {
    at(i).share = std::min(at(i).share, share);
  }
}

void SpeedLaw::begin(int rounds) noexcept {
  for (std::size_t i = 0; i < size_; ++i) {
    const double share = std::exchange(at(i).share, 1.0);
    if (share == 1.0) continue;
    slow_down(at(i).limits, share);
    at(i).slowed *= share;
  }
  pass_ = Pass::kBackward;
  rounds_ = rounds;
  next_ = size_ - 1;
  at(size_ - 1).most = largest_square(capped(at(size_ - 1)));
}

SpeedLaw::Progress SpeedLaw::work(std::size_t intervals) noexcept {
  for (std::size_t i = 0; i < intervals && pass_ != Pass::kDone; ++i) {
    switch (pass_) {
      case Pass::kBackward:
        pass_back(--next_);
        if (next_ > 0) break;
        pass_ = Pass::kForward;
        to_add_ = 0;
        next_ = 0;
        at(0).square = std::min(start_square_, most_at(0));
        break;
      case Pass::kForward:
        pass_forth(next_);
        if (++next_ + 1 < size_) break;
        pass_ = to_add_ > 0 && --rounds_ > 0 && size_ + to_add_ <= most_ ? Pass::kAdd : Pass::kDone;
        break;
      case Pass::kAdd:
        add_points();
        pass_ = Pass::kBackward;
        next_ = size_ - 1;
        break;
      case Pass::kDone:
        break;
    }
  }
  return pass_ == Pass::kDone ? Progress::kDone : Progress::kWorking;
}

void SpeedLaw::pass_back(std::size_t point) noexcept {
  Point& near = at(point);
  const Point& far = at(point + 1);
  const double step = far.s - near.s;
  const LawLimits limits = capped(near);
  const double own = largest_square(limits), far_most = most_at(point + 1);
  near.most = step > 0.0 ? LawInterval{limits, capped(far), step}.largest_near(far_most) : std::min(own, far_most);
  near.brakes = near.most < own * (1.0 - kSameSquare);
}

void SpeedLaw::pass_forth(std::size_t point) noexcept {
  Point& near = at(point);
  Point& far = at(point + 1);
  const double step = far.s - near.s, far_most = most_at(point + 1);
  near.add_after = 0.0;
  if (!(step > 0.0)) {
    far.square = stops(point + 1) ? 0.0 : near.square;
    return;
  }
  const LawLimits far_limits = capped(far);
  const LawInterval interval{capped(near), far_limits, step};
  far.square = interval.fastest_far(near.square, far_most);
  if (far.square < far_most * (1.0 - kSameSquare)) return;  // accelerates all the way

  // Where the line x(s) of the present motion meets that of the law behind it.
  const double closest = kClosestPoints * step;
  const auto add_after = [&](double after, bool large_change) {
    const bool inside = after > closest && after < step - closest;
    const bool between_points = after > kSamePlace * step && after < (1.0 - kSamePlace) * step;
    if (!inside && !(large_change && between_points)) return false;
    near.add_after = std::clamp(after, closest, step - closest);
    ++to_add_;
    return true;
  };
  const auto differ = [](double less, double more) { return less < more * (1.0 - kLargeChange); };
  if (!near.brakes && (stops(point + 1) || far.brakes)) {
    const double own = largest_square(far_limits);
    const double rises = -2.0 * interval.accelerations(far_most).low;
    const double before = (own - far_most) / (rises - (near.most - own) / step);
    if (add_after(step - before, differ(far_most, own))) return;
  }
  if (near.square < near.most * (1.0 - kSameSquare)) {
    const double rises = 2.0 * interval.accelerations(near.square).high, falls = (near.most - far_most) / step;
    add_after((near.most - near.square) / (rises + falls), differ(near.square, near.most));
  }
}

// One sweep from the back, so that every point moves once.
void SpeedLaw::add_points() noexcept {
  std::size_t to = size_ + to_add_;
  size_ = to;
  for (std::size_t from = to - to_add_; from-- > 0;) {
    const Point& point = at(from);
    const double after = std::exchange(at(from).add_after, 0.0);
    if (after > 0.0) {
      // `from + 1` has already moved to `to`.
      const Point added = between(point, at(to), point.s + after);
      at(--to) = added;
    }
    at(--to) = at(from);
  }
}

}  // namespace armature
