// The parameter of a path over time, as a sequence of parabolas, or of cubics where jerk is limited: what is left of
// the law of a path for its execution.
#pragma once

#include <array>
#include <cstddef>

#include "controller/base/units.hpp"
#include "controller/trajectory/law/speed_law.hpp"

namespace armature {

class TimeTable {
 public:
  // Of the moving average of a law, which has two for each point of the law and of what keep() leaves before it.
  static constexpr std::size_t kMaxKept = 1024, kMaxKeptOfAverage = 256;
  static constexpr std::size_t kMaxPoints = 2 * (SpeedLaw::kMaxPoints + kMaxKept) + kMaxKeptOfAverage;
  struct Point {
    double t_s = 0.0;
    double s = 0.0;
    double speed = 0.0;  // of the parameter, 1/s
    double jerk = 0.0;   // of the parameter after the point, 1/s^3
  };

  TimeTable() = default;
  // Copies only size() points; those beyond keep their old values.
  TimeTable(const TimeTable& other) noexcept { *this = other; }
  TimeTable& operator=(const TimeTable& other) noexcept;

  void clear() noexcept { size_ = 0; }
  // Takes the law of a path whose passes are done, from rest. Points within one parabola are left out. The motion
  // between two stops takes whole ticks: its duration is rounded up, and the motion is slower by that share everywhere.
  void assign(const SpeedLaw& law) noexcept;

  // Builds another table, in order of time. A point at the time of the last one replaces it.
  void append(const Point& point) noexcept;
  void end(Ticks duration) noexcept { duration_ = duration; }

  // To continue a table in motion: removes what is before `from_s` and behind the point `last` of this table, and
  // counts the time from tick `origin` on. Call it only if can_keep() is true for `last`: at most `most` points are
  // left.
  [[nodiscard]] bool can_keep(double from_s, const Point& last, std::size_t most) const noexcept;
  void keep(double from_s, const Point& last, Ticks origin) noexcept;
  // Appends a law whose passes are done to what keep() has left. It begins at its last point with the speed there, and
  // is not slowed down up to its first stop: the motion rests there until the tick ends. Can be repeated.
  void continue_with(const SpeedLaw& law) noexcept;
  // Removes everything behind what keep() has left.
  void drop_behind_kept() noexcept;
  // The end of what keep() has left.
  [[nodiscard]] const Point& kept_end() const noexcept { return points_[kept_ - 1]; }

  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] const Point& operator[](std::size_t point) const noexcept { return points_[point]; }
  [[nodiscard]] Ticks duration() const noexcept { return duration_; }
  // Of cubics at its end: with limited jerk.
  [[nodiscard]] bool is_smooth() const noexcept { return size_ > 1 && points_[size_ - 2].jerk != 0.0; }

  // The parameter at `t_s`: exact at the points, constant before the first and after the last. A binary search among
  // the points.
  [[nodiscard]] double position(double t_s) const noexcept;
  // The first time at which the parameter is `s`.
  [[nodiscard]] double time_at(double s) const noexcept { return passing(s).t_s; }
  // The time, and the speed there.
  [[nodiscard]] Point passing(double s) const noexcept;
  // The time from which on the motion only brakes, until its end.
  [[nodiscard]] double brakes_from_s() const noexcept;
  // The mean acceleration of the parameter between a point, except the last, and the next one.
  [[nodiscard]] double accel(std::size_t point) const noexcept;

 private:
  struct Range {
    std::size_t first, end;  // `end` is the one behind
  };
  [[nodiscard]] Range between(double from_s, double to_s) const noexcept;
  template <typename Condition>
  [[nodiscard]] std::size_t last_that(Condition condition) const noexcept;
  void append(const SpeedLaw& law) noexcept;
  // Leaves out points between two equal accelerations, from `first` on.
  void merge(std::size_t first) noexcept;

  std::array<Point, kMaxPoints> points_{};
  std::size_t size_ = 0;
  std::size_t kept_ = 0;
  Ticks duration_{};
};

}  // namespace armature
