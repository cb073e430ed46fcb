// Plans motions of the tool and checks them before the first pulse: every set-point that the motion loop will send is
// computed here, at every tick, against reach, joint limits, joint speed, acceleration and jerk and the 4 Mpps of the
// pulse generators. Where a joint would be too fast, the time laws of the segments that are then active are stretched,
// the path stays; beyond `max_stretch` the motion is refused.
//
// One pass over all set-points finds how much slower each segment has to be; the plan is made again and passed again,
// until a whole pass finds nothing. Usually that is the second. What is not clean after kMostPasses is refused, so
// nothing unchecked is ever driven.
//
// Corners are rounded only where that makes the chain shorter: a corner whose blend costs its segments more time than
// the overlap saves is an exact stop. Where the joints then ask for so much more time that exact stops everywhere might
// be faster, and where a rounded chain is refused because of its corners, the chain with exact stops is planned as well
// and the shorter one taken. So a chain with blends never takes longer than without, and is accepted where that is.
//
// On a five-axis arm the tool is held in the arm's plane, five_axis_turning.hpp; its tool point is on the path exactly
// whatever the tool. An end orientation beyond ArmGeometry::max_projection_rad is refused before the first set-point is
// looked at, as kOrientation at the end of its segment.
//
// The planner works in slices, so that its core can listen in between.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/arm_plane.hpp"
#include "controller/trajectory/blend.hpp"
#include "controller/trajectory/cartesian_plan.hpp"
#include "controller/trajectory/path_check.hpp"
#include "controller/trajectory/path_problem.hpp"
#include "controller/trajectory/segment_request.hpp"
#include "controller/trajectory/time_law.hpp"

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
  // What needs no sample is decided at once: kRefused without a circle or beyond a five-axis arm's
  // orientations, kDone without a way.
  void begin(const JointAngles& start, std::span<const SegmentRequest> chain) noexcept;
  void give_up() noexcept;  // kIdle

  // Computes up to `samples` set-points, one inverse kinematics each.
  Progress work(std::size_t samples) noexcept;
  [[nodiscard]] Progress progress() const noexcept { return progress_; }

  [[nodiscard]] const CartesianPlan& plan() const noexcept { return plan_; }      // kDone
  [[nodiscard]] const PathProblem& problem() const noexcept { return problem_; }  // kRefused
  // Passes over all set-points completed since begin(), of at most two chains.
  [[nodiscard]] int passes() const noexcept { return passes_; }

 private:
  using PerSegment = std::array<double, CartesianPlan::kMostSegments>;

  [[nodiscard]] bool lay_out(const JointAngles& start, std::span<const SegmentRequest> chain) noexcept;
  void choose_corners() noexcept;
  void plan_law(std::size_t index) noexcept;
  [[nodiscard]] Ticks time_of_pair(std::size_t first) const noexcept;
  [[nodiscard]] bool lay_out_orientation(std::size_t segment, Transform& from, const SegmentRequest& request) noexcept;
  [[nodiscard]] bool schedule() noexcept;
  void begin_pass() noexcept;
  void accept() noexcept;
  void begin_with_exact_stops() noexcept;
  void end_refused(bool because_of_corners) noexcept;
  void step() noexcept;
  void note_failure(const IkTracking& tracking) noexcept;
  void end_pass() noexcept;
  void refuse_as_too_fast(std::size_t segment, const PathCheck::Excess& excess) noexcept;
  void refuse(PathProblem::Kind kind, std::size_t segment) noexcept;

  const Arm& arm_;
  ArmPlane plane_;
  double max_stretch_;

  Progress progress_ = Progress::kIdle;
  CartesianPlan plan_{};
  PathProblem problem_{};
  PathCheck::Limits limits_{};
  std::array<ProfileKind, CartesianPlan::kMostSegments> profile_{};
  PerSegment blend_mm_{};                                        // [i]: asked for between segments i and i + 1
  std::array<Corner, CartesianPlan::kMostSegments> corner_{};    // [i]: chosen there
  std::array<TimeLaw, CartesianPlan::kMostSegments> fastest_{};  // before stretching
  PerSegment stretch_{};

  PathCheck check_;
  int passes_ = 0;
  int passes_of_plan_ = 0;
  bool rounded_ = false;  // the plan that is being checked has rounded corners
  Ticks least_exact_{};   // no chain with exact stops is shorter
  bool has_rounded_plan_ = false;
  CartesianPlan rounded_plan_{};  // checked; the one with exact stops is being checked
  std::int64_t tick_ = 0;
  bool failed_in_corner_ = false;
  std::int64_t failed_until_ = 0;  // > 0: a set-point cannot be reached; the rest of its segment is looked at, too
  JointAngles joints_{};
};

}  // namespace armature
