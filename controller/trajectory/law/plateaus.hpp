// The peaks and valleys of a law that are too sharp for a motion with limited jerk.
//
// The moving average of a law over a time tau (moving_average.hpp) has the third derivative (u(t) - u(t - tau)) / tau,
// where u is the acceleration of the law. Each |u| is at most tau / j, with j = LawLimits::Jerk::by_change, so one
// change from or to a constant speed keeps the limit. A change from accelerating to braking within tau may need twice
// as much. It keeps the limit if the law has a constant speed for tau in between: a plateau that cuts a peak or fills a
// valley. A valley is filled also where the moving average would pass it faster than the law by more than a tenth,
// because its speed may be limited by the acceleration or the jerk across the path.
#pragma once

#include <array>
#include <cstddef>

#include "controller/trajectory/law/moving_average.hpp"
#include "controller/trajectory/law/speed_law.hpp"
#include "controller/trajectory/law/time_table.hpp"

namespace armature {

// The law must be limited to `square` between two places.
struct Plateau {
  double from = 0.0, to = 0.0;
  double square = 0.0;
  double longer_s = 0.0;  // by which the law takes longer then, about
};

class Plateaus {
 public:
  static constexpr std::size_t kMax = 256;

  // Finds the plateaus that a motion of `table` needs. `law` is the law of the table. Where there are more than kMax,
  // the others are found when these have been made. `joint`: the motion is already executed up to this point, so
  // plateaus begin behind it and are no slower than the speed there; null: nothing is executed.
  void find(const TimeTable& table, const TableRun& motion, double tau_s, const SpeedLaw& law,
            const TimeTable::Point* joint = nullptr) noexcept;

  [[nodiscard]] std::size_t size() const noexcept { return count_; }
  [[nodiscard]] const Plateau& operator[](std::size_t i) const noexcept { return found_[i]; }

 private:
  // Of find(), for its steps.
  struct Run {
    const TimeTable& table;
    std::size_t first, last;
    double tau_s;
    const TimeTable::Point* joint;

    // After a point; 0 outside of the run.
    [[nodiscard]] double accel(std::size_t point) const noexcept {
      return point >= first && point < last ? table.accel(point) : 0.0;
    }
    [[nodiscard]] bool executed(double until_s) const noexcept { return joint != nullptr && until_s <= joint->t_s; }
  };
  // The points within a time of tau, and the change of the acceleration over it.
  struct Window {
    std::size_t from, to;
    double change;
    double by_change;  // tau that each change needs

    [[nodiscard]] std::size_t fastest(const TimeTable& table) const noexcept;
    [[nodiscard]] std::size_t slowest(const TimeTable& table) const noexcept;
  };
  class Peak;
  void flatten(const Run& run, const Window& window) noexcept;
  void cut(const Run& run, std::size_t at) noexcept;
  void fill(const Run& run, std::size_t valley) noexcept;
  void add(const Run& run, Plateau plateau) noexcept;

  std::array<Plateau, kMax> found_{};
  std::size_t count_ = 0;
};

}  // namespace armature
