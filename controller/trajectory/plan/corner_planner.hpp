// The search for a corner between a joint move and a path (path_joint_corner.hpp) that takes the least time.
//
// It works in steps, so that its core can accept commands in between. A step plans a joint move or checks one.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/joint/corner_search.hpp"
#include "controller/trajectory/joint/joint_chain.hpp"
#include "controller/trajectory/joint/joint_retarget.hpp"
#include "controller/trajectory/plan/path_joint_corner.hpp"

namespace armature {

// The work of a step.
struct CornerWork {
  std::int64_t inverses = 0;   // inverse kinematics; four forward ones count as one
  std::int64_t retargets = 0;  // joint plans from a state of motion
};
// No step takes more. A step with joint plans has at most 150 inverse kinematics, so the longest one takes 1.6 ms
// where an inverse kinematics takes 7 us and a joint plan 14 us. Usually a step takes 0.3 ms.
inline constexpr CornerWork kMaxOfStep{.inverses = 220, .retargets = 12};

// A path that leads into a joint move with a corner.
struct PathBefore {
  const CartesianPlan* path = nullptr;
  Ticks from{};  // its execution begins there
  double blend_mm = 0.0;
};

// The first joint move after a path, to rest.
struct Departure {
  Ticks at{};           // in the time of the path; at its end the arm stops
  RetargetPlan plan{};  // a duration above kLongestMove must not be executed
  Ticks passed{};       // as JointChain::passed
};

class DeparturePlanner {
 public:
  // References must outlive the planner.
  DeparturePlanner(const RobotModel& robot, const Arm& arm, const PathBefore& before,
                   const JointRequest& request) noexcept;

  // Until done().
  void step() noexcept;
  [[nodiscard]] bool done() const noexcept { return stage_ == Stage::kDone; }
  [[nodiscard]] const CornerWork& work() const noexcept { return work_; }      // of the last step
  [[nodiscard]] const Departure& departure() const noexcept { return best_; }  // done()

 private:
  enum class Stage : std::uint8_t { kStop, kPlan, kCheck, kDone };

  [[nodiscard]] RetargetPlan plan_from(std::int64_t tick) noexcept;
  void plan() noexcept;
  void check() noexcept;
  void end() noexcept;

  const RobotModel& robot_;
  PathExit exit_;
  JointRequest request_;
  EarliestFit search_;
  Stage stage_ = Stage::kStop;
  RetargetPlan trial_{};
  Departure stop_{}, best_{};
  CornerWork work_{};
};

// The last move of a joint chain before a path.
struct ArrivalRequest {
  double speed = 1.0;  // of this move, as its acceleration
  double accel = 1.0;
  double blend_rad = 0.0;  // these three as for PathEntry
  double blend_share = 0.0;
  double half_way_rad = 0.0;
  double blend_before_rad = 0.0;  // of the corner between this move and the one before in the chain
  // If it is the first move of the chain and begins in motion: the path before, and when it is left.
  std::optional<PathBefore> before{};
  Ticks exit_at{};
};

// Lets the move end in motion on the path.
class ArrivalPlanner {
 public:
  // References must outlive the planner. The chain is changed by the last step.
  ArrivalPlanner(const RobotModel& robot, const Arm& arm, JointChain& chain, const CartesianPlan& path,
                 const ArrivalRequest& request) noexcept;

  // Until done().
  void step() noexcept;
  [[nodiscard]] bool done() const noexcept { return stage_ == Stage::kDone; }
  [[nodiscard]] const CornerWork& work() const noexcept { return work_; }  // of the last step
  // done(): where the move ends, in the time of the path. 0: the arm stops at its start, and the chain is unchanged.
  [[nodiscard]] Ticks at() const noexcept { return Ticks{at_}; }
  // done(): the time at which the path before is left. It may differ from that without this corner.
  [[nodiscard]] Ticks exit_at() const noexcept { return exit_at_; }

 private:
  enum class Stage : std::uint8_t { kPrepare, kPlan, kCheck, kCheckBegin, kDone };

  [[nodiscard]] PerAxis<AxisState> start_at(std::int64_t begin) noexcept;
  [[nodiscard]] bool keeps_before(const RetargetPlan& plan, std::int64_t begin) noexcept;
  void search_end() noexcept;
  void search_begin() noexcept;
  void plan() noexcept;
  void check() noexcept;
  void check_begin() noexcept;
  void end_search() noexcept;
  void end() noexcept;

  const RobotModel& robot_;
  JointChain& chain_;
  ArrivalRequest request_;
  PathEntry entry_;
  std::optional<PathExit> exit_;
  const RetargetPlan* before_ = nullptr;  // the move before in the chain
  // When the move begins, in the time of what is before it: without this corner, and the time when that is at rest.
  std::int64_t begin_alone_ = 0, rest_before_ = 0;

  Stage stage_ = Stage::kPrepare;
  EarliestFit search_{0, 0};
  bool searches_begin_ = false;  // otherwise the end
  bool found_ = false;
  int entries_ = 0;  // ends for which the start was searched
  // The present trial: begin and end of the move.
  std::int64_t trial_begin_ = 0, trial_end_ = 0;
  RetargetPlan trial_{};
  // The best one.
  std::int64_t begin_ = 0, at_ = 0;
  RetargetPlan best_{};
  Ticks exit_at_{};
  CornerWork work_{};
};

}  // namespace armature
