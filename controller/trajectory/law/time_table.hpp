// The parameter of a path over time, as a sequence of parabolas, or of cubics where jerk is limited: what is left of
// the law of a path for its execution.
#pragma once

#include <array>
#include <cstddef>

#include "controller/core/units.hpp"
#include "controller/trajectory/law/speed_law.hpp"

namespace armature {

class TimeTable {
 public:
  static constexpr std::size_t kMaxPoints = SpeedLaw::kMaxPoints;
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

  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] const Point& operator[](std::size_t point) const noexcept { return points_[point]; }
  [[nodiscard]] Ticks duration() const noexcept { return duration_; }

  // The parameter at `t_s`: exact at the points, constant before the first and after the last. A binary search among
  // the points.
  [[nodiscard]] double position(double t_s) const noexcept;
  // The first time at which the parameter is `s`.
  [[nodiscard]] double time_at(double s) const noexcept;
  // The mean acceleration of the parameter between a point, except the last, and the next one.
  [[nodiscard]] double accel(std::size_t point) const noexcept;

 private:
  void merge() noexcept;

  std::array<Point, kMaxPoints> points_{};
  std::size_t size_ = 0;
  Ticks duration_{};
};

}  // namespace armature
