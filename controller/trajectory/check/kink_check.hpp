// Checks set-points between ticks where the time laws of a Cartesian plan have kinks.
//
// After a hold or an override the set-points are anywhere between the ticks of the plan. This makes no difference where
// accelerations (of trapezoids) or jerks (of S-curves) change smoothly. At a kink it does. A change that lasts for less
// than a tick, for example where one segment brakes before the next one begins, is only partly contained in differences
// over ticks, depending on the position of the ticks. So around each kink the differences are taken at every quarter of
// a tick, those of the joints and the acceleration of the tool.
//
// A law has many points. Those count as kinks from which on its acceleration changes, within a tick, by more than
// kLeastKink of the largest one around: many small steps in a tick are as much as one, and the acceleration along one
// segment says nothing about another. Less than kLeastOfAll of the largest one of the plan does not count. In a window,
// for which core 1 has little time, only single jumps count, compared with the largest acceleration of the window.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/check/path_check.hpp"

namespace armature {

class KinkCheck {
 public:
  // The arm must outlive the check.
  explicit KinkCheck(const Arm& arm) noexcept : arm_{arm} {}

  // Call at the start of a plan.
  void begin(const CartesianPlan& plan) noexcept;

  // Call at every tick from 1 on with the joints there. When the first set-point around a kink is reached, adds the
  // set-points around it to `check`; two kinks within a tick share theirs. Returns the number of computed inverse
  // kinematics: 0 at most ticks, otherwise for each kink kPoints, or up to FollowedTool::kMaxInverses times as many
  // near the wrist singularity. At tick 1 there may be five kinks, of ticks 0..4; of the first four only the points
  // after the start count.
  static constexpr int kPoints = 29;
  static constexpr int kMax = 16 + 20 + 24 + 28 + kPoints;
  int sample(const CartesianPlan& plan, std::int64_t tick, const JointAngles& joints, PathCheck& check) noexcept;
  // The next tick is the one behind this one. Leaves out the kinks around which a set-point up to it would be added.
  void skip_to(std::int64_t tick) noexcept;

 private:
  static constexpr std::int64_t kBefore = 3;  // ticks; a jerk is measured over as many
  static constexpr std::int64_t kAfter = 4;   // ticks from the last tick before the kink
  static constexpr std::int64_t kParts = 4;   // per tick

  int sample_around(const CartesianPlan& plan, std::int64_t kink, const JointAngles& joints, PathCheck& check) const;

  const Arm& arm_;
  static constexpr double kLeastKink = 0.1, kLeastKinkOfJerk = 0.5, kLeastOfAll = 1e-3;
  static constexpr std::size_t kMaxKinks = TimeTable::kMaxPoints;
  void add_kinks(const TimeTable& table, bool in_window) noexcept;

  std::array<std::int64_t, kMaxKinks> kinks_{};  // last ticks before kinks, in order
  std::size_t count_ = 0;
  std::size_t next_ = 0;
};

}  // namespace armature
