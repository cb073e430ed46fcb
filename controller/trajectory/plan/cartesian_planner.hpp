// Plans motions of the tool and checks them before the first pulse. It checks the set-points that the motion loop will
// send against reach, joint limits, joint speed, acceleration and jerk, the limits of the tool and the 4 Mpps of the
// pulse generators: by bounds for whole intervals of time, and one by one where these do not show enough. Where
// something would be too fast, the motion is slowed down and the path stays. Beyond `max_stretch` times the time of a
// segment the motion is refused.
//
// The steps, in this order, each in its own file:
//   path_layout     from requests to segments, and the errors of the requests
//   path_corners    the joints between segments, and rounded corners
//   path_reach      points without a solution
//   chain_law       the fastest law along the path, smoothed where jerk is limited
//   bend_layout     passages of the wrist singularity on which the orientation may leave the path; the law begins again
//   path_pass       all set-points
//   planned_outputs the times of the outputs on the path
// One pass over all set-points finds where the motion must be slower, if anywhere. It is timed and passed again, until
// a whole pass finds no excess. A plan with an excess after kMaxPasses is refused, so no unchecked plan is executed.
//
// A chain is timed as one path: it is slow only where it must be, and stops only where its direction breaks without a
// blend. If a rounded corner cannot be executed, the chain is planned again with exact stops.
//
// A plan can be a window over a longer path: extend() plans the next one while it is executed. What both have in common
// is neither laid out nor gridded again; the law is planned again from the joint on, and every set-point from there on
// is checked again.
//
// The planner works in slices, so that its core can accept commands in between.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/bend_layout.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/check/path_check.hpp"
#include "controller/trajectory/check/path_pass.hpp"
#include "controller/trajectory/grid/chain_law.hpp"
#include "controller/trajectory/path/arm_plane.hpp"
#include "controller/trajectory/path/path_problem.hpp"
#include "controller/trajectory/path/segment_request.hpp"
#include "controller/trajectory/plan/planned_outputs.hpp"

namespace armature {

class CartesianPlanner {
 public:
  enum class Progress : std::uint8_t { kIdle, kWorking, kDone, kRefused };

  // A place that needs more time gets that time plus a margin, which doubles with each pass. So the passes end.
  static constexpr int kMaxPasses = 12;
  // A singularity is reported when its indicator (Manipulability) is below this.
  static constexpr double kNearSingular = 0.1;

  // References must outlive the planner. `max_stretch` >= 1.
  CartesianPlanner(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool,
                   double max_stretch) noexcept;
  CartesianPlanner(const CartesianPlanner&) = delete;
  CartesianPlanner& operator=(const CartesianPlanner&) = delete;

  // `chain` must stay as it is while the planner works. Begins with a chain of 1..kMaxFirstSegments segments from where
  // the arm stands, at rest; cancels the previous work. Everything that needs no sample of the path is decided at once:
  // kRefused for the problems of lay_out_path() and find_unreachable() and for more than kLongestSegment, kDone for a
  // path of no length. At most three inverse kinematics for each segment. `after_unasked_stop`: of the plan.
  void begin(const JointAngles& start, std::span<const SegmentRequest> chain, bool after_unasked_stop = false) noexcept;
  void cancel() noexcept;  // kIdle

  // Continues the present plan, which can_continue(), while it is executed: the next plan agrees with it up to a tick
  // after `earliest`, where the arm moves, and has further segments, `added`. `blend_mm` is that of the last present
  // segment. False, and nothing is changed: `added` has more than room() segments, or one that may_continue() excludes,
  // or S-curves behind a plan without them, or the motion ends too soon after `earliest`. kRefused then has no
  // problem(): the present plan is too fast for what follows, or what follows cannot be executed. begin() at its end
  // then says what. False as well: more outputs than room_for_outputs().
  [[nodiscard]] bool extend(Ticks earliest, double blend_mm, std::span<const SegmentRequest> added) noexcept;
  // True when extend() is possible with the present plan: it is kDone, moves, has outputs only on their own segments,
  // and its motion behind the last exact stop has an S-curve if the plan has any.
  [[nodiscard]] bool can_continue() const noexcept {
    return progress_ == Progress::kDone && !plan_.table.empty() && law_.can_continue() &&
           outputs_.on_own_segments(plan_);
  }
  // Whether a plan that continues the present one may have segments of this kind.
  [[nodiscard]] bool may_add(ProfileKind profile) const noexcept {
    return profile == ProfileKind::kTrapezoid || law_.smooth();
  }
  // The time of the present plan before which another one should continue it: later it loses speed at its end.
  [[nodiscard]] double continue_before_s() const noexcept;
  // The number of segments of the present plan, which can_continue(), that are not over at this tick.
  [[nodiscard]] std::size_t segments_left(Ticks tick) const noexcept;
  // The number of segments that extend() can add to the present plan from this tick on; 0: it cannot continue.
  [[nodiscard]] std::size_t room(Ticks earliest) const noexcept;
  // The same for their outputs.
  [[nodiscard]] std::size_t room_for_outputs(Ticks earliest) const noexcept;

  // Continues until it has done the work of `inverses` inverse kinematics, or up to PathPass::kMaxInverses more: one
  // for each set-point, more at kinks of time laws and near the wrist singularity; for a law one for each interval. A
  // bend of the wrist is placed at once, with some hundred.
  Progress work(std::int64_t inverses) noexcept;
  [[nodiscard]] Progress progress() const noexcept { return progress_; }

  [[nodiscard]] const CartesianPlan& plan() const noexcept { return plan_; }      // kDone
  [[nodiscard]] const PathProblem& problem() const noexcept { return problem_; }  // kRefused
  // Completed passes over all set-points since begin(), of at most two chains.
  [[nodiscard]] int passes() const noexcept { return passes_; }
  // Inverse kinematics computed by work() since begin() or extend(), up to the end of the first pass: for the law and
  // for the set-points.
  struct Work {
    std::int64_t law = 0, pass = 0;
  };
  [[nodiscard]] const Work& first_work() const noexcept { return first_work_; }
  // Inverse kinematics computed by work() since begin().
  [[nodiscard]] std::int64_t inverses() const noexcept { return inverses_; }

 private:
  void begin_chain() noexcept;
  [[nodiscard]] std::size_t segments_over(double t_s) const noexcept;
  void move_origin(Ticks origin, double same_until_s) noexcept;
  void plan_law() noexcept;
  void end_law() noexcept;
  void lay_out_bends() noexcept;
  void lower(const PathCheck::Place& place) noexcept;
  void lower_pending() noexcept;
  [[nodiscard]] double margin() const noexcept;
  void end_pass() noexcept;
  void finish() noexcept;
  // The singularity that is near at a place of the path.
  [[nodiscard]] std::uint8_t singularity_at(double s) noexcept;
  // `at`: share of the segment.
  void refuse_as_too_fast(std::size_t segment, double at, std::uint8_t axis, std::uint8_t singular,
                          double stretch) noexcept;
  void refuse(const PathProblem& problem, bool because_of_corners) noexcept;

  const Arm& arm_;
  ArmPlane plane_;
  double max_stretch_;

  Progress progress_ = Progress::kIdle;
  CartesianPlan plan_{};
  std::span<const SegmentRequest> chain_{};
  PlannedOutputs outputs_;
  PathProblem problem_{};
  ChainLaw law_;
  bool planning_law_ = false;
  BendLayout bends_;
  enum class Bends : std::uint8_t { kNotConsidered, kLayingOut, kDone };
  Bends bends_stage_ = Bends::kDone;
  // Of the present pass: the largest excess, and one that may still grow.
  PathCheck::Place worst_{}, lowered_{};
  PathPass pass_;
  int passes_ = 0;
  int passes_of_chain_ = 0;
  Work first_work_{};
  std::int64_t inverses_ = 0;
};

}  // namespace armature
