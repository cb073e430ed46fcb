#include "controller/trajectory/law/time_table.hpp"

#include <algorithm>
#include <cmath>

#include "controller/core/timebase.hpp"
#include "controller/trajectory/profile/synchronise.hpp"

namespace armature {
namespace {

constexpr int kTimeHalvings = 50;
constexpr double kSameAccel = 1e-9, kSameSpeed = 1e-13;  // shares

}  // namespace

TimeTable& TimeTable::operator=(const TimeTable& other) noexcept {
  std::copy_n(other.points_.begin(), other.size_, points_.begin());
  size_ = other.size_;
  duration_ = other.duration_;
  return *this;
}

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
  merge();
}

void TimeTable::append(const Point& point) noexcept {
  if (size_ > 0 && point.t_s <= points_[size_ - 1].t_s) {
    points_[size_ - 1] = point;
  } else if (size_ < kMaxPoints) {
    points_[size_++] = point;
  }
}

// Leaves out points between two equal accelerations.
void TimeTable::merge() noexcept {
  std::size_t kept = 0;
  for (std::size_t i = 1; i + 1 < size_; ++i) {
    if (points_[i].t_s <= points_[kept].t_s) continue;  // the same place
    const Point &a = points_[kept], &b = points_[i], &c = points_[i + 1];
    const double first = (b.speed - a.speed) / (b.t_s - a.t_s), second = (c.speed - b.speed) / (c.t_s - b.t_s);
    const bool one = std::fabs(first - second) <= kSameAccel * std::max(std::fabs(first), std::fabs(second)) ||
                     std::fabs(a.speed - b.speed) + std::fabs(c.speed - b.speed) <= kSameSpeed * b.speed;
    if (b.speed > 0.0 && (one || !(c.t_s > b.t_s))) continue;
    points_[++kept] = b;
  }
  points_[++kept] = points_[size_ - 1];
  size_ = kept + 1;
}

double TimeTable::position(double t_s) const noexcept {
  if (t_s <= points_[0].t_s) return points_[0].s;
  std::size_t low = 0, high = size_ - 1;
  if (t_s >= points_[high].t_s) return points_[high].s;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (points_[middle].t_s <= t_s ? low : high) = middle;
  }
  const Point &a = points_[low], &b = points_[high];
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

double TimeTable::time_at(double s) const noexcept {
  if (s <= points_[0].s) return points_[0].t_s;
  std::size_t low = 0, high = size_ - 1;
  if (s >= points_[high].s) return points_[high].t_s;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (points_[middle].s < s ? low : high) = middle;
  }
  const Point &a = points_[low], &b = points_[high];
  if (a.jerk != 0.0) {
    double before_s = a.t_s, after_s = b.t_s;
    for (int i = 0; i < kTimeHalvings; ++i) {
      const double middle_s = 0.5 * (before_s + after_s);
      (position(middle_s) < s ? before_s : after_s) = middle_s;
    }
    return after_s;
  }
  const double step = b.s - a.s;
  const double accel = 0.5 * (b.speed - a.speed) * (b.speed + a.speed) / step;
  const double speed = std::sqrt(std::max(a.speed * a.speed + 2.0 * accel * (s - a.s), 0.0));
  return std::min(b.t_s, a.t_s + 2.0 * (s - a.s) / (a.speed + speed));
}

}  // namespace armature
