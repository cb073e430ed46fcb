// One tick of a change of the rate under limits of jerk: the rate that comes nearest to the wanted one while joints and
// tool keep their limits of acceleration and jerk.
//
// With r the rate, u its change per tick and w the change of u, a motion q(t) of the plan has in this tick
//
//   acceleration  q'' r^2 + q' u          jerk  q''' r^3 + 3 q'' r u + q' w        (per tick, tick^2, tick^3)
//
// Both are linear in w. So each joint and the tool leave an interval of w, and w is the value in all of them that
// brings u to where it should be. Within this tick nothing else limits it: the jerk of the plan counts with its sign,
// so a hold brakes at once, with the whole jerk, wherever the plan does not do so already.
//
// u itself has bounds, which leave room for the ticks that come.
//
//   End      The change must end at the wanted rate g with u = 0. To the plan at this rate the motion has the distance
//            e = q' (r - g) in speed, which changes by e' = q' u + q'' r (r - g). It ends in time while
//            e'^2 <= 2 |e| J', with J' the part of the jerk that the plan at the rate g leaves:
//            J' = J - |q'''| r^2 g - |q''| |u| g. Where g = 0, this is the whole limit, and e, e' are the joint's own
//            speed and acceleration. Near g = 1 the jerk that the plan needs in the time of the change decides. In a
//            joint move all joints must end with the w that the slowest one has: they share w, but not their laws.
//   Reversal A joint that turns round has q' = 0 there, so w has no effect on it. So it must have
//            |u| <= (J - |q'''| r^3) / (3 |q''| r). Such a joint is one that could not stop before with its jerk:
//            q''^2 > 2 J |q'|.
//   Bend     The same for the acceleration of the tool across its direction of motion.
//   Braking  Where a joint brakes in the plan, 3 q'' r u acts in the direction of the w that ends the change. In a
//            joint move its bound is that of a reversal, with the sign of q''': joints share w, but not their laws.
//            Otherwise u might have to grow to keep the jerk of one joint, until the rate is 0 or 1.
//   Limit    Where the jerk of the plan brings a joint nearer to its acceleration limit A, in a joint move:
//            |u| <= (A - |q''| r^2) / |q'|, with the q'' to which this jerk leads. Otherwise the joint would need at
//            its limit a w that is too large for another one.
//   Rest     u must reach 0 before the rate leaves 0..1. The w for that is u^2 / (2 left + |u|), with `left` the rate's
//            distance from 0 or 1. It stays the same while u decreases by it, so it is applied in spite of all other
//            bounds where it would become larger than 1.15 J / |q'| of the slowest joint: a last resort, which limits
//            the excess where motions contradict each other.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/base/axes.hpp"

namespace armature {

// Whether a change of the rate keeps the limits of jerk, and what is known of the joints.
enum class RateJerk : std::uint8_t {
  kAny,        // jerk is not limited
  kMonotonic,  // no joint turns round, and all speed up and slow down together: joint moves from rest
  kReversing,  // joints may turn round, and may need all of their jerk: joint moves that begin in motion
  kTurning     // joints may turn round, but need little of their jerk: paths of the tool
};

class RateChange {
 public:
  // The rate of the last tick, its change in that tick, and the wanted rate, 0..1.
  RateChange(double rate, double rate_step, double wanted, RateJerk jerk) noexcept;

  // The rate with the same change; it may be slightly outside 0..1. The motions below are those at this rate, in any
  // unit of length.
  [[nodiscard]] double kept() const noexcept { return kept_; }

  template <class Length>
  struct Motion {
    Length speed;   // q' of the next set-point, per tick
    Length accel;   // q'', per tick^2
    Length bend;    // the second difference of the set-points with the next one
    Length change;  // the third difference
    double max_bend = 0.0;
    double max_change = 0.0;  // infinite where jerk is not limited
    double peak = 0.0;        // the largest |q''| of the plan; of joint moves only
  };
  void add(const Motion<double>& joint) noexcept;
  void add(const Motion<Eigen::Vector3d>& tool) noexcept;

  // The time to the end of the change, ticks of the plan: the distance to look ahead.
  [[nodiscard]] double ahead() const noexcept;
  // Call last. `plan_jerk`: the largest jerk of the plan until then, as a share of the limits, at the rate 1.
  [[nodiscard]] double rate(double plan_jerk) noexcept;

 private:
  struct Range {
    double low, high;
    void cut(double from, double to) noexcept;
    [[nodiscard]] bool empty() const noexcept { return low > high; }
    // If the range is empty, between its bounds.
    [[nodiscard]] double nearest(double value) const noexcept;
  };
  // What the end of the change needs: of a joint, or of the tool in its direction of motion.
  struct End {
    double quickest = 0.0;  // J / |q'|
    double growth = 0.0;    // q'' / q'
  };

  // A joint that may turn round: magnitudes of its motion, and its limit of jerk.
  struct Turn {
    double speed = 0.0, accel = 0.0, jerk = 0.0, plan_jerk = 0.0;
  };

  [[nodiscard]] bool joint_move() const noexcept { return kind_ != RateJerk::kTurning; }
  void end(double speed, double accel, double jerk) noexcept;
  void cut_jerk(double middle, double half) noexcept;
  void limit_step(double jerk_left, double accel) noexcept;
  void limit_across(double jerk, double accel, double w) noexcept;
  // The least decrease of |u| per tick that brings u to 0 before `rate` leaves 0..1.
  [[nodiscard]] static double needed_to_stop(double rate, double step) noexcept;
  // `change`, or what the rest of the change needs at least.
  [[nodiscard]] double enough_to_stop(double change) const noexcept;
  [[nodiscard]] double step_to_end(const End& end, double wanted, double share) const noexcept;

  static constexpr std::size_t kMaxMotions = kAxes + 2 + 1;

  double rate_, step_, wanted_, kept_;
  double left_;  // of the change, >= 0
  double sign_;  // of the change
  Range jerk_, accel_;
  double most_step_;
  double slowest_;
  std::array<End, kMaxMotions> ends_{};
  std::size_t count_ = 0;
  std::array<Turn, kAxes> turns_{};
  std::size_t turn_count_ = 0;
  RateJerk kind_;
};

}  // namespace armature
