// The parameter of a path over time, as a sequence of parabolas: what the law of a path leaves for its execution.
//
// A table belongs to one sampler. Times increase; a sample costs O(1), because successive samples are near each other.
#pragma once

#include <array>
#include <cstddef>

#include "controller/core/units.hpp"
#include "controller/trajectory/law/speed_law.hpp"

namespace armature {

class TimeTable {
 public:
  struct Point {
    double t_s = 0.0;
    double s = 0.0;
    double speed = 0.0;  // of the parameter, 1/s
  };

  // Takes the points of a law whose passes are done. The motion between two stops takes whole ticks: its duration is
  // rounded up, and the motion is slower by that share everywhere.
  void assign(const SpeedLaw& law) noexcept;

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] const Point& operator[](std::size_t point) const noexcept { return points_[point]; }
  [[nodiscard]] Ticks duration() const noexcept { return duration_; }

  // The interval 0..size() - 2 that contains `t_s`, searched from `hint`.
  [[nodiscard]] std::size_t interval_at(double t_s, std::size_t hint) const noexcept;
  // The parameter at `t_s`, which should be in this interval: exact at both ends, constant outside of the table.
  [[nodiscard]] double position(double t_s, std::size_t interval) const noexcept;
  // The time at which the parameter is `s`; the first one of a stop.
  [[nodiscard]] double time_at(double s) const noexcept;

 private:
  std::array<Point, SpeedLaw::kMaxPoints> points_{};
  std::size_t size_ = 0;
  Ticks duration_{};
};

}  // namespace armature
