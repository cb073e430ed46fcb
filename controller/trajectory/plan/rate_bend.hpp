// How fast the rate of a plan may change where jerk is limited (path_clock.hpp): w, the largest second difference of
// the rate, in 1/tick^2.
#pragma once

#include <array>
#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"
#include "controller/trajectory/plan/joint_chain.hpp"
#include "controller/trajectory/plan/joint_move.hpp"
#include "controller/trajectory/plan/motion_plan.hpp"

namespace armature {

// The largest w for a quantity whose speed in the plan is at most `speed`, its acceleration at most min(accel,
// sqrt(jerk speed)) and its jerk at most `jerk`, all of them per s^n. With r the rate and u = dr/dt a motion q(t) has
// the jerk
//
//   jerk = q_ppp r^3 + 3 q_pp r u + q_p du/dt,   q_p, q_pp, q_ppp: the plan's speed, acceleration, jerk
//
// Rates are within 0..1 and change between constant values, so u^2 <= 2 w (1 - r). With w = 0.4 min(J / V, (J / A)^2)
// the sum is at most 2 J, at r = 0.88. An S-curve always has A^2 <= J V, so its A need not be given. A quantity at rest
// allows any w. w is never below kMinBend, with which a hold takes an hour: a smaller change of a rate of 1 could not
// be represented by a double.
inline constexpr double kMinBend = 1e-15;
[[nodiscard]] double rate_bend(double speed, double jerk, double accel = 0.0) noexcept;

// For a joint move: every axis that moves in an S-curve keeps twice the robot's jerk.
[[nodiscard]] double rate_bend(const JointPlan& plan, const RobotModel& robot) noexcept;
[[nodiscard]] double rate_bend(const RetargetPlan& plan, const RobotModel& robot) noexcept;
[[nodiscard]] double rate_bend(const JointChain& plan, const RobotModel& robot) noexcept;
// For a joined plan: the least of all its moves.
[[nodiscard]] double rate_bend(const MotionPlan& plan, const RobotModel& robot) noexcept;

// The part of a Cartesian plan between two exact stops. Where the tool rests the rate may begin a new change, so each
// such run has its own w: the least of its segments.
struct PlanRun {
  double rate_bend = kAnyBend;
  double end_ticks = 0.0;  // path time, from the start of the plan
};
// The run at this path time; at an exact stop the one that begins.
[[nodiscard]] PlanRun run_at(const CartesianPlan& plan, double ticks) noexcept;

// Measures the motion of the joints on the segments of a plan from its set-points, and sets
// CartesianSegment::rate_bend. With it joints, tool and rotation keep twice their jerks on S-curves; kAnyBend on other
// segments.
class BendMeter {
 public:
  explicit BendMeter(const RobotModel& robot) noexcept : robot_{robot} {}

  // The arm rests at the start of a plan.
  void begin() noexcept;
  // Adds the set-point at `tick`, which starts at 1 and increases by one, with the differences of PathCheck,
  // and how far the tool moved and turned since the one before.
  void add(const CartesianPlan& plan, std::int64_t tick, const PerAxis<double>& steps_rad,
           const PerAxis<double>& bends_rad, double move_mm, double turn_rad) noexcept;
  // Call after the last set-point.
  void store(CartesianPlan& plan) const noexcept;

 private:
  struct Peaks {
    PerAxis<double> step_rad{};  // per tick
    PerAxis<double> bend_rad{};  // per tick^2
    double move_mm = 0.0, turn_rad = 0.0;
  };
  const RobotModel& robot_;
  std::size_t oldest_ = 0;  // the active segment that began first
  std::array<Peaks, CartesianPlan::kMaxSegments> peaks_{};
};

}  // namespace armature
