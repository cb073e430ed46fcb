// Plans motions of the tool and checks them before the first pulse: every set-point that the motion loop will send is
// computed here, at every tick, against reach, joint limits, joint speed, acceleration and jerk and the 4 Mpps of the
// pulse generators. Where a joint would be too fast, the time laws of the segments that are then active are stretched,
// the path stays; beyond `max_stretch` the motion is refused.
//
// In this order, each in a file of its own:
//   path_layout   from requests to segments, or what is wrong with the requests
//   path_reach    points that have no solution at all
//   chain_timing  rounded corners, the fastest laws, one segment after the other
//   path_pass     every set-point
// One pass over all set-points finds how much slower each segment has to be; the plan is timed again and passed again,
// until a whole pass finds nothing. Usually that is the second. What is not clean after kMostPasses is refused, so
// nothing unchecked is ever driven.
//
// Corners are rounded where their two segments by themselves are then faster. Where the joints ask for so much more
// time that exact stops everywhere might be faster, and where a rounded chain is refused because of its corners, the
// chain with exact stops is planned as well and the shorter one taken. So a chain with blends never takes longer than
// without, and is accepted where that is.
//
// The planner works in slices, so that its core can listen in between.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/path/arm_plane.hpp"
#include "controller/trajectory/path/path_problem.hpp"
#include "controller/trajectory/path/segment_request.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"
#include "controller/trajectory/plan/chain_timing.hpp"
#include "controller/trajectory/plan/path_check.hpp"
#include "controller/trajectory/plan/path_pass.hpp"

namespace armature {

class CartesianPlanner {
 public:
  enum class Progress : std::uint8_t { kIdle, kWorking, kDone, kRefused };

  // A segment that needs more time gets that and a little more, from pass to pass twice as much more (0.1 % at first,
  // 100 % at last): that ends also where a stretched corner asks for more again.
  static constexpr int kMostPasses = 12;
  // A singularity is named where its indicator (Manipulability) is below this.
  static constexpr double kNearSingular = 0.1;

  // References must outlive the planner. `max_stretch` >= 1.
  CartesianPlanner(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool,
                   double max_stretch) noexcept;
  CartesianPlanner(const CartesianPlanner&) = delete;
  CartesianPlanner& operator=(const CartesianPlanner&) = delete;

  // Begins with a chain of 1..kMostSegments segments from where the arm stands, at rest. Gives up what it was doing.
  // What needs no sample of the path is decided at once: kRefused for what lay_out_path() and find_unreachable() find
  // and for what takes longer than kLongestSegment, kDone without a way. At most three inverse kinematics a segment.
  void begin(const JointAngles& start, std::span<const SegmentRequest> chain) noexcept;
  void give_up() noexcept;  // kIdle

  // Goes on along the path until it has computed `inverses` inverse kinematics, or up to PathPass::kMostInverses more:
  // one a set-point, more at kinks of time laws and next to the wrist singularity.
  Progress work(std::int64_t inverses) noexcept;
  [[nodiscard]] Progress progress() const noexcept { return progress_; }

  [[nodiscard]] const CartesianPlan& plan() const noexcept { return plan_; }      // kDone
  [[nodiscard]] const PathProblem& problem() const noexcept { return problem_; }  // kRefused
  // Passes over all set-points completed since begin(), of at most two chains.
  [[nodiscard]] int passes() const noexcept { return passes_; }
  // Inverse kinematics that work() has computed since begin().
  [[nodiscard]] std::int64_t inverses() const noexcept { return inverses_; }

 private:
  void begin_chain() noexcept;
  void begin_pass() noexcept;
  void end_pass() noexcept;
  void stretch(const PathCheck::PerSegment& excess, std::size_t worst) noexcept;
  void accept() noexcept;
  void refuse_as_too_fast(std::size_t segment, const PathCheck::Excess& excess) noexcept;
  void refuse(const PathProblem& problem, bool because_of_corners) noexcept;

  const Arm& arm_;
  ArmPlane plane_;
  double max_stretch_;

  Progress progress_ = Progress::kIdle;
  CartesianPlan plan_{};
  PathProblem problem_{};
  ChainTiming timing_;
  PathPass pass_;
  int passes_ = 0;
  int passes_of_chain_ = 0;
  std::int64_t inverses_ = 0;
  bool has_rounded_plan_ = false;
  CartesianPlan rounded_plan_{};  // checked; the one with exact stops is being checked
};

}  // namespace armature
