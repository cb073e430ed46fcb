// Looks at set-points between ticks where the time laws of a Cartesian plan have kinks.
//
// After a hold or an override the set-points lie anywhere between the ticks of the plan. Where accelerations (of
// trapezoids) or jerks (of S-curves) change smoothly that makes no difference. At a kink it does: what lasts for less
// than a tick, as where one segment brakes before the next one begins, differences over ticks see in part only, and how
// much of it depends on where the ticks lie. So around each kink they are taken at every quarter of a tick.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"
#include "controller/trajectory/plan/path_check.hpp"

namespace armature {

class KinkCheck {
 public:
  // The arm must outlive the check.
  explicit KinkCheck(const Arm& arm) noexcept : arm_{arm} {}

  // At the start of a plan.
  void begin(const CartesianPlan& plan) noexcept;

  // Called at every tick from 1 on with the joints there. Adds the set-points around a kink to `check` when the first
  // of them is reached; those around two kinks within a tick are the same. Returns how many inverse kinematics that
  // took: none at most ticks, else for each kink kPoints, or up to FollowedTool::kMostInverses times as many next to
  // the wrist singularity. At tick 1 there may be five, of ticks 0..4, of the first four only what comes after the
  // start.
  static constexpr int kPoints = 29;
  static constexpr int kMost = 16 + 20 + 24 + 28 + kPoints;
  int look(const CartesianPlan& plan, std::int64_t tick, const JointAngles& joints, PathCheck& check) noexcept;

 private:
  static constexpr std::int64_t kBefore = 3;  // ticks, as many as a jerk is measured over
  static constexpr std::int64_t kAfter = 4;   // from the last tick before the kink
  static constexpr std::int64_t kParts = 4;   // of a tick

  int look_around(const CartesianPlan& plan, std::int64_t kink, const JointAngles& joints, PathCheck& check) const;

  const Arm& arm_;
  std::array<std::int64_t, CartesianPlan::kMostSegments * Kinks::kMost> kinks_{};  // last ticks before kinks, in order
  std::size_t count_ = 0;
  std::size_t next_ = 0;
};

}  // namespace armature
