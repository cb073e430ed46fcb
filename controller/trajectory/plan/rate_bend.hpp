// How suddenly the rate of a plan may change where jerk is limited (path_clock.hpp): w, the largest second difference
// of the rate, in 1/tick^2.
#pragma once

#include <array>
#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"
#include "controller/trajectory/plan/joint_move.hpp"

namespace armature {

// The largest w for something that moves by up to `speed` and accelerates by up to min(accel, sqrt(jerk speed)) in the
// plan, and whose plan keeps `jerk`, all of them per s^n. With r the rate and u = dr/dt a motion q(t) has the jerk
//
//   jerk = q_ppp r^3 + 3 q_pp r u + q_p du/dt,   q_p, q_pp, q_ppp: the plan's speed, acceleration, jerk
//
// Rates are within 0..1 and change from and to standing values, so u^2 <= 2 w (1 - r). With w = 0.4 min(J / V, (J /
// A)^2) the sum is at most 2 J, at r = 0.88. An S-curve never has A^2 > J V, so that its A need not be told. What rests
// may have any w. Never below kLeastBend, with which a hold takes an hour: a rate could not leave 1 by less than what a
// double can tell from it.
inline constexpr double kLeastBend = 1e-15;
[[nodiscard]] double rate_bend(double speed, double jerk, double accel = 0.0) noexcept;

// Of a joint move: every axis that moves in an S-curve keeps twice the robot's jerk.
[[nodiscard]] double rate_bend(const JointPlan& plan, const RobotModel& robot) noexcept;

// The part of a Cartesian plan between two exact stops. Where the tool rests the rate may begin to change anew, so each
// such run has a w of its own: the least of its segments.
struct PlanRun {
  double rate_bend = kAnyBend;
  double end_ticks = 0.0;  // path time, from the start of the plan
};
// The run that is under way at this path time; at an exact stop the one that begins.
[[nodiscard]] PlanRun run_at(const CartesianPlan& plan, double ticks) noexcept;

// Measures what the joints do on the segments of a plan, from its set-points, and notes CartesianSegment::rate_bend:
// that joints, tool and turning keep twice their jerks on S-curves; kAnyBend on other segments.
class BendMeter {
 public:
  explicit BendMeter(const RobotModel& robot) noexcept : robot_{robot} {}

  // At rest at the start of a plan.
  void begin() noexcept;
  // The set-point at `tick`, > 0 and one more each time, from what PathCheck says about it.
  void add(const CartesianPlan& plan, std::int64_t tick, const PerAxis<double>& steps_rad,
           const PerAxis<double>& bends_rad) noexcept;
  // After the last one.
  void note(CartesianPlan& plan) const noexcept;

 private:
  struct Peaks {
    PerAxis<double> step_rad{};  // per tick
    PerAxis<double> bend_rad{};  // per tick^2
  };
  const RobotModel& robot_;
  std::size_t oldest_ = 0;  // segment that is under way since longest
  std::array<Peaks, CartesianPlan::kMostSegments> peaks_{};
};

}  // namespace armature
