#include "controller/trajectory/law/time_table.hpp"

#include <algorithm>
#include <cmath>

#include "controller/core/timebase.hpp"
#include "controller/trajectory/profile/synchronise.hpp"

namespace armature {

void TimeTable::assign(const SpeedLaw& law) noexcept {
  size_ = law.size();
  duration_ = {};
  points_[0] = {.s = law.s(0), .speed = std::sqrt(law.square(0))};
  std::size_t stop = 0;  // the last one
  for (std::size_t i = 1; i < size_; ++i) {
    Point& point = points_[i];
    const Point& before = points_[i - 1];
    point = {.s = law.s(i), .speed = std::sqrt(law.square(i))};
    const double step = point.s - before.s;
    // Relative to the last stop.
    const double since_s = i - 1 == stop ? 0.0 : before.t_s;
    point.t_s = since_s + (step > 0.0 ? 2.0 * step / (point.speed + before.speed) : 0.0);
    if (point.speed > 0.0) continue;

    const Ticks whole = whole_ticks(point.t_s);
    const double slower = point.t_s > 0.0 ? seconds(whole) / point.t_s : 1.0;
    for (std::size_t k = stop + 1; k <= i; ++k) {
      points_[k].t_s = seconds(duration_) + points_[k].t_s * slower;
      points_[k].speed /= slower;
    }
    duration_ = duration_ + whole;
    point.t_s = seconds(duration_);
    stop = i;
  }
}

std::size_t TimeTable::interval_at(double t_s, std::size_t hint) const noexcept {
  std::size_t i = std::min(hint, size_ - 2);
  while (i > 0 && t_s < points_[i].t_s) --i;
  while (i + 2 < size_ && t_s >= points_[i + 1].t_s) ++i;
  return i;
}

double TimeTable::position(double t_s, std::size_t interval) const noexcept {
  const Point &a = points_[interval], &b = points_[interval + 1];
  if (t_s <= a.t_s) return a.s;
  if (t_s >= b.t_s) return b.s;
  // From the nearer end, exact at both.
  const double half_accel = 0.5 * (b.speed - a.speed) / (b.t_s - a.t_s);
  if (t_s - a.t_s <= b.t_s - t_s) {
    const double after_s = t_s - a.t_s;
    return a.s + (a.speed + half_accel * after_s) * after_s;
  }
  const double left_s = b.t_s - t_s;
  return b.s - (b.speed - half_accel * left_s) * left_s;
}

double TimeTable::time_at(double s) const noexcept {
  if (s <= points_[0].s) return points_[0].t_s;
  std::size_t low = 0, high = size_ - 1;
  if (s >= points_[high].s) return points_[high].t_s;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (points_[middle].s < s ? low : high) = middle;
  }
  const Point &a = points_[low], &b = points_[high];
  const double step = b.s - a.s;
  const double accel = 0.5 * (b.speed - a.speed) * (b.speed + a.speed) / step;
  const double speed = std::sqrt(std::max(a.speed * a.speed + 2.0 * accel * (s - a.s), 0.0));
  return std::min(b.t_s, a.t_s + 2.0 * (s - a.s) / (a.speed + speed));
}

}  // namespace armature
