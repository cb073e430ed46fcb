#include "controller/trajectory/law/time_table.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/profile/synchronise.hpp"

namespace armature {
namespace {

constexpr int kTimeHalvings = 50;
constexpr double kSameAccel = 1e-9, kSameSpeed = 1e-13;  // shares
constexpr double kSamePlace_s = 1e-9;

}  // namespace

TimeTable& TimeTable::operator=(const TimeTable& other) noexcept {
  std::copy_n(other.points_.begin(), other.size_, points_.begin());
  size_ = other.size_;
  kept_ = other.kept_;
  duration_ = other.duration_;
  return *this;
}

void TimeTable::assign(const SpeedLaw& law) noexcept {
  points_[0] = {.s = law.s(0), .speed = std::sqrt(law.square(0))};
  size_ = 1;
  kept_ = 0;
  duration_ = {};
  append(law);
  merge(0);
}

// The points from the last one at or before `from_s` on, those at `to_s` not included.
TimeTable::Range TimeTable::between(double from_s, double to_s) const noexcept {
  std::size_t first = 0;
  while (first + 1 < size_ && points_[first + 1].t_s <= from_s) ++first;
  std::size_t end = first;
  while (end < size_ && points_[end].t_s < to_s) ++end;
  return {first, end};
}

bool TimeTable::can_keep(double from_s, const Point& last, std::size_t most) const noexcept {
  const Range kept = between(from_s, last.t_s);
  return kept.end - kept.first + 1 <= most;
}

void TimeTable::keep(double from_s, const Point& last, Ticks origin) noexcept {
  const Range kept = between(from_s, last.t_s);
  for (std::size_t i = kept.first; i < kept.end; ++i) points_[i - kept.first] = points_[i];
  size_ = kept.end - kept.first;
  points_[size_++] = last;
  kept_ = size_;
  for (std::size_t i = 0; i < size_; ++i) points_[i].t_s -= seconds(origin);
}

void TimeTable::drop_behind_kept() noexcept {
  size_ = kept_;
  duration_ = {};
}

void TimeTable::continue_with(const SpeedLaw& law) noexcept {
  drop_behind_kept();
  append(law);
  merge(kept_ - 1);
}

// From the last point on, which is the first one of the law.
void TimeTable::append(const SpeedLaw& law) noexcept {
  std::size_t run = size_ - 1;  // the last stop, or the first point
  const std::size_t in_motion = points_[run].speed > 0.0 ? run : kMaxPoints;
  for (std::size_t i = 1; i < law.size(); ++i) {
    const Point& before = points_[size_ - 1];
    const std::size_t present = size_++;
    Point& point = points_[present];
    point = {.s = law.s(i), .speed = std::sqrt(law.square(i))};
    const double step = point.s - before.s;
    // Relative to the start of the run.
    const double since_s = present - 1 == run ? 0.0 : before.t_s;
    point.t_s = since_s + (step > 0.0 ? 2.0 * step / (point.speed + before.speed) : 0.0);
    if (point.speed > 0.0) continue;

    if (run == in_motion) {
      for (std::size_t k = run + 1; k <= present; ++k) points_[k].t_s += points_[run].t_s;
      duration_ = whole_ticks(point.t_s);
      points_[size_++] = {.t_s = std::max(seconds(duration_), point.t_s), .s = point.s};
    } else {
      const Ticks whole = whole_ticks(point.t_s);
      const double slower = point.t_s > 0.0 ? seconds(whole) / point.t_s : 1.0;
      for (std::size_t k = run + 1; k <= present; ++k) {
        points_[k].t_s = seconds(duration_) + points_[k].t_s * slower;
        points_[k].speed /= slower;
      }
      duration_ = duration_ + whole;
      point.t_s = seconds(duration_);
    }
    run = size_ - 1;
  }
}

void TimeTable::append(const Point& point) noexcept {
  if (size_ > 0 && point.t_s <= points_[size_ - 1].t_s) {
    points_[size_ - 1] = point;
  } else if (size_ < kMaxPoints) {
    points_[size_++] = point;
  }
}

void TimeTable::merge(std::size_t first) noexcept {
  std::size_t kept = first;
  for (std::size_t i = first + 1; i + 1 < size_; ++i) {
    if (points_[i].t_s <= points_[kept].t_s) continue;  // the same place
    const Point &a = points_[kept], &b = points_[i], &c = points_[i + 1];
    const double before = (b.speed - a.speed) / (b.t_s - a.t_s), behind = (c.speed - b.speed) / (c.t_s - b.t_s);
    const bool one = std::fabs(before - behind) <= kSameAccel * std::max(std::fabs(before), std::fabs(behind)) ||
                     std::fabs(a.speed - b.speed) + std::fabs(c.speed - b.speed) <= kSameSpeed * b.speed;
    if (b.speed > 0.0 && (one || !(c.t_s > b.t_s))) continue;
    points_[++kept] = b;
  }
  points_[++kept] = points_[size_ - 1];
  size_ = kept + 1;
}

// The last point, except the end, for which `condition` is true: it is for the first one, and not for the end.
template <typename Condition>
std::size_t TimeTable::last_that(Condition condition) const noexcept {
  const auto begin = points_.begin() + 1, end = points_.begin() + size_ - 1;
  return static_cast<std::size_t>(std::partition_point(begin, end, condition) - begin);
}

double TimeTable::position(double t_s) const noexcept {
  if (t_s <= points_[0].t_s) return points_[0].s;
  if (t_s >= points_[size_ - 1].t_s) return points_[size_ - 1].s;
  const std::size_t low = last_that([t_s](const Point& point) { return point.t_s <= t_s; });
  const Point &a = points_[low], &b = points_[low + 1];
  // From the nearer end, exact at both.
  const double mean = accel(low), change = 0.5 * a.jerk * (b.t_s - a.t_s), sixth = a.jerk / 6.0;
  const double after_s = t_s - a.t_s, left_s = b.t_s - t_s;
  return after_s <= left_s ? a.s + (a.speed + (0.5 * (mean - change) + sixth * after_s) * after_s) * after_s
                           : b.s - (b.speed - (0.5 * (mean + change) - sixth * left_s) * left_s) * left_s;
}

double TimeTable::accel(std::size_t point) const noexcept {
  const Point &a = points_[point], &b = points_[point + 1];
  return (b.speed - a.speed) / (b.t_s - a.t_s);
}

TimeTable::Point TimeTable::passing(double s) const noexcept {
  if (s <= points_[0].s) return points_[0];
  if (s >= points_[size_ - 1].s) return points_[size_ - 1];
  const std::size_t low = last_that([s](const Point& point) { return point.s < s; });
  const Point &a = points_[low], &b = points_[low + 1];
  if (a.jerk != 0.0) {
    double before_s = a.t_s, after_s = b.t_s;
    for (int i = 0; i < kTimeHalvings; ++i) {
      const double middle_s = 0.5 * (before_s + after_s);
      (position(middle_s) < s ? before_s : after_s) = middle_s;
    }
    const double t_s = after_s - a.t_s, change = 0.5 * a.jerk * (b.t_s - a.t_s);
    return {.t_s = after_s, .s = s, .speed = a.speed + (accel(low) - change + 0.5 * a.jerk * t_s) * t_s};
  }
  const double step = b.s - a.s;
  const double accel = 0.5 * (b.speed - a.speed) * (b.speed + a.speed) / step;
  const double speed = std::sqrt(std::max(a.speed * a.speed + 2.0 * accel * (s - a.s), 0.0));
  return {.t_s = std::min(b.t_s, a.t_s + 2.0 * (s - a.s) / (a.speed + speed)), .s = s, .speed = speed};
}

double TimeTable::brakes_from_s() const noexcept {
  std::size_t first = size_ - 1;
  // Points at the same place may differ by rounding.
  const auto brakes_before = [this](std::size_t i) {
    const Point &a = points_[i - 1], &b = points_[i];
    return a.speed > b.speed * (1.0 + kSameAccel) || b.speed == 0.0 || b.t_s - a.t_s < kSamePlace_s;
  };
  while (first > 0 && brakes_before(first)) --first;
  return points_[first].t_s;
}

}  // namespace armature
