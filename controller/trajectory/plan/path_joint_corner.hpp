// A corner between a path of the tool and a joint move, in either order, that is passed without a stop.
//
// The joint move begins or ends in a state of motion on the path, so the rest of the path is not executed. From there
// on only the limits of the joints apply. How far the corner may be from the exact one is a deviation, not a zone:
//
//   path to joint move   In mm, as for corners between paths: at one set-point the tool is within it of the end of the
//                        path, and before that it is no farther from the path. A rotation counts as the way of a point
//                        at kTurnLever_mm.
//   joint move to path   In rad, as for corners between joint moves: at one set-point every joint is within it of the
//                        start of the path, and after that no joint is farther from where the path has it.
//
// At most half of the path's first or last segment, in time, is left out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/cartesian/path_cursor.hpp"
#include "controller/trajectory/joint/joint_retarget.hpp"

namespace armature {

// Where a joint move begins on a path.
class PathExit {
 public:
  // `path` is executed from `from` on. References must outlive this.
  PathExit(const RobotModel& robot, const Arm& arm, const CartesianPlan& path, Ticks from, double blend_mm) noexcept;

  // The ticks of the path at which the joint move may begin: from early() on; at the end the arm rests.
  [[nodiscard]] std::int64_t early() const noexcept { return early_; }
  [[nodiscard]] std::int64_t end() const noexcept { return cursor_.plan().duration.value(); }

  // To be repeated until it returns true, before the functions below are called for that tick.
  [[nodiscard]] bool approach(std::int64_t tick) noexcept;
  [[nodiscard]] PerAxis<AxisState> state_at(std::int64_t tick) noexcept { return cursor_.state_at(tick); }
  // Whether a move that begins in state_at(tick) keeps the deviation, and the change to it the limits of the joints.
  [[nodiscard]] bool keeps(const RetargetPlan& plan, std::int64_t tick) noexcept;
  // The tick of the plan that keeps() has found closest to the end of the path.
  [[nodiscard]] Ticks passed() const noexcept { return passed_; }

  // Inverse kinematics so far.
  [[nodiscard]] std::int64_t inverses() const noexcept { return cursor_.inverses() + forwards_ / 4; }

 private:
  const RobotModel& robot_;
  const Arm& arm_;
  PathCursor cursor_;
  double blend_mm_;
  std::int64_t early_;
  Ticks passed_{};
  std::int64_t forwards_ = 0;
};

// Where a joint move ends on a path.
class PathEntry {
 public:
  // The deviation: `blend_rad` or, if that is 0, this share of `half_way_rad` or of the way on the first half of the
  // segment, whichever is less. References must outlive this.
  PathEntry(const RobotModel& robot, const Arm& arm, const CartesianPlan& path, double blend_rad, double share,
            double half_way_rad) noexcept;

  // The last tick of the path at which the joint move may end; at 0 the arm rests.
  [[nodiscard]] std::int64_t late() const noexcept { return late_; }

  // To be repeated until it returns true, before anything else.
  [[nodiscard]] bool prepare() noexcept;
  // As PathExit::approach().
  [[nodiscard]] bool approach(std::int64_t tick) noexcept;
  [[nodiscard]] PerAxis<AxisState> state_at(std::int64_t tick) noexcept { return cursor_.state_at(tick); }
  // Whether a move that ends in state_at(tick) keeps the deviation, and the change to the path the limits.
  [[nodiscard]] bool keeps(const RetargetPlan& plan, std::int64_t tick) noexcept;

  // Inverse kinematics so far.
  [[nodiscard]] std::int64_t inverses() const noexcept { return cursor_.inverses(); }

 private:
  // Points of the path from its start to late().
  static constexpr std::size_t kPoints = 64;
  [[nodiscard]] std::int64_t tick_of(std::size_t point) const noexcept {
    return late_ * static_cast<std::int64_t>(point) / static_cast<std::int64_t>(kPoints);
  }

  const RobotModel& robot_;
  PathCursor cursor_;
  std::int64_t late_ = 0;
  double blend_rad_;
  double share_;
  double half_way_rad_;
  std::array<JointAngles, kPoints + 1> points_{};
  std::size_t count_ = 0;  // of points_ that are known
};

}  // namespace armature
