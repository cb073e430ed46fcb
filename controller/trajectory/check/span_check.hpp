// Whether a motion along a span of its path keeps the limits of joints and tool for an interval of time.
//
// With the derivatives q', q'', q''' of a quantity by the parameter s, and the speed v, acceleration a and jerk j of s,
//   speed q' v,   acceleration q'' v^2 + q' a,   jerk q''' v^3 + 3 q'' v a + q' j.
// Each is computed at both ends of the interval. Between them it is farther from 0 than at an end by at most an eighth
// of the square of the time, times the largest second derivative by time, which is known from the largest derivatives
// of the curves. Here it counts twice, because the derivatives of a curve are less exact than the curve itself. The
// errors of the curves (PathSpan::errors) are added.
//
// So the bounds hold at every time, not only at ticks: for all set-points, wherever a hold or an override shifts them.
// A difference over ticks is a mean of such values, so it keeps the limit as well, if speeds do not jump and, for a
// jerk, accelerations do not: see joins().
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/check/path_span.hpp"
#include "controller/trajectory/law/time_table.hpp"

namespace armature {

// The parameter over time: s = s + speed t + accel t^2 / 2 + jerk t^3 / 6.
struct SpanMotion {
  double s = 0.0, speed = 0.0, accel = 0.0, jerk = 0.0;

  [[nodiscard]] SpanMotion after(double t_s) const noexcept {
    return {s + (speed + (0.5 * accel + jerk / 6.0 * t_s) * t_s) * t_s, speed + (accel + 0.5 * jerk * t_s) * t_s,
            accel + jerk * t_s, jerk};
  }
};

// That of a table after one of its points, except the last.
[[nodiscard]] SpanMotion motion_after(const TimeTable& table, std::size_t point) noexcept;
// When a motion is at `s`, which it reaches within `most_s`.
[[nodiscard]] double time_at(const SpanMotion& motion, double s, double most_s) noexcept;

class SpanCheck {
 public:
  explicit SpanCheck(const RobotModel& robot) noexcept;

  // Whether curves that are off by `misfit` in their middle may be used at speeds up to `speed`. A feature of the path
  // between the samples that is so narrow that it shows only by this misfit could change a set-point by no more than a
  // small share of what the limits permit in a tick.
  [[nodiscard]] bool fits(const CartesianSegment& segment, const SpanMisfit& misfit, double speed) const noexcept;

  // `segment`: whose limits apply.
  struct Result {
    bool kept = false;
    double jerk_share = 0.0;  // kept: at most this share of the limits of jerk (PathCheck::jerk_share())
    // Not kept, and a limit is exceeded at both ends: as PathCheck::Place, for the lesser excess.
    double stretch = 1.0;
    std::uint8_t axis = 0;
  };
  [[nodiscard]] Result check(const CartesianSegment& segment, const PathSpan& span, const SpanMotion& from,
                             double duration_s) const noexcept;

  // Whether jumps of the parameter, its speed and its acceleration between two intervals are too small to matter: in a
  // difference over ticks less than 0.1 % of what is permitted, 1 % of a jerk.
  [[nodiscard]] bool joins(const CartesianSegment& segment, const PathSpan& span, const SpanMotion& before,
                           const SpanMotion& behind) const noexcept;

 private:
  // The motion in an interval, and the largest values in it.
  struct Interval {
    SpanMotion first, last;
    double duration_s = 0.0, speed = 0.0, accel = 0.0, jerk = 0.0;
    bool smooth = false;
  };
  struct Rates {
    double speed = 0.0, accel = 0.0, jerk = 0.0;
  };
  // Sizes at both ends, and how much larger they may be between them.
  struct Ends {
    Rates first, last, more;
  };
  // Whether a condition holds for each curve: condition(curve, largest acceleration, largest jerk).
  template <class Condition>
  [[nodiscard]] bool all_curves(const CartesianSegment& segment, Condition condition) const noexcept;
  [[nodiscard]] static Rates most_between(const PathSpan& span, std::size_t curve, const Interval& interval) noexcept;
  [[nodiscard]] static Rates rates(const SpanCurve::Derivatives& by_s, const SpanMotion& motion) noexcept;
  // Compares sizes with limits. `axis`: 0 is the tool.
  static void judge(const Ends& ends, const Rates& limits, bool smooth, std::uint8_t axis, Result& result) noexcept;
  void check_joint(const PathSpan& span, std::size_t axis, double joint_accel, const Interval& interval,
                   Result& result) const noexcept;
  static void check_tool(const PathLimits& limits, const PathSpan& span, const Interval& interval,
                         Result& result) noexcept;
  static void check_exact_tool(const CartesianSegment& segment, const Interval& interval, Result& result) noexcept;

  std::size_t axis_count_;
  PerAxis<double> speed_{}, accel_{}, jerk_{};  // checked limits; jerk infinite where the axis has none
  PerAxis<double> lowest_rad_{}, highest_rad_{};
};

}  // namespace armature
