// Finds the times of a plan at which no limit is exceeded, without its set-points one by one.
//
// The path is covered by spans (path_span.hpp): where the curves between two samples do not fit, the way between them
// is halved. On each span the law is checked by bounds, one interval of its table after the other (span_check.hpp); an
// interval for which the bounds do not show enough is halved. So the work grows with the shape of the path and of its
// law, not with its duration.
//
// Where a limit is exceeded for long, this is known as well. What is left is unknown, and its set-points must be
// checked one by one: ways and intervals of a few ticks, places where the direction of the path jumps, beside
// singularities and limits of joints, on bends of the wrist, and where the path cannot be executed.
//
// How sure it is that a time which is kept keeps the limits:
//   - For a curve and a law the bounds are proved, at every time of an interval.
//   - How far a curve is off its path is measured at a third place and added to the bounds, with what it may be off
//     elsewhere if the path is smooth between the samples. That is not proved, but joints depend algebraically on the
//     place, so what is narrower than a way bends the curve far around: at the third place it is off by much more than
//     the 1e-9 rad or so that SpanCheck::fits() accepts. Except where a side of the arm changes: a way that passes a
//     singularity is halved until its set-points are checked.
//   - Jumps of the law between two intervals are not added; SpanCheck::joins() limits them.
// tests/controller/trajectory/path_bounds_test.cpp compares what is kept with all set-points of random chains, and says
// how far they exceed a limit. It is far less than the 2 % by which the checked limits of the joints are lower than
// those of the axes (PathCheck::kCheckedShare).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/check/path_check.hpp"
#include "controller/trajectory/check/path_span.hpp"
#include "controller/trajectory/check/span_check.hpp"

namespace armature {

class PathBounds {
 public:
  // Robot and arm must outlive this.
  PathBounds(const RobotModel& robot, const Arm& arm) noexcept : arm_{arm}, check_{robot} {}

  // Starts with a plan that takes at least one tick and must be the same for all step()s.
  void begin(const CartesianPlan& plan) noexcept;

  // What is known up to ticks(), from where the step before has ended. kSearching: nothing new. kExceeded: see
  // excess(). kEnd: the rest of the plan is unknown; the last step.
  enum class Found : std::uint8_t { kSearching, kKept, kExceeded, kUnknown, kEnd };
  Found step(const CartesianPlan& plan) noexcept;
  // Call after kUnknown before the next step, with the joints close behind ticks(): another branch of the inverse
  // kinematics may be nearest to the samples before that time.
  void continue_from(const JointAngles& joints) noexcept;
  [[nodiscard]] double ticks() const noexcept;
  // After kKept: of PathCheck::jerk_share(), at most.
  [[nodiscard]] double jerk_share() const noexcept { return jerk_share_; }
  // After kExceeded: as PathCheck::Place.
  [[nodiscard]] const PathCheck::Place& excess() const noexcept { return excess_; }
  // The last sample that was taken of the path. Its orientation error counts for the segment in which it is.
  [[nodiscard]] const SpanSample& sample() const noexcept { return last_; }
  // kKept, and the path is at sample() at ticks().
  [[nodiscard]] bool at_sample() const noexcept { return at_sample_; }
  // The cost of the last step, in inverse kinematics: bounds of an interval take about as long as one.
  [[nodiscard]] int inverses() const noexcept { return inverses_; }

  // Shorter intervals are not checked by bounds, and shorter ones that exceed a limit are unknown.
  static constexpr double kFewestTicks = 4.0, kLongExcessTicks = 40.0;

 private:
  // On the way to a place, from the present time on.
  struct Passage {
    double speed = 0.0, t_s = 0.0;  // the largest speed, and the time there
  };
  [[nodiscard]] Passage passage(const CartesianPlan& plan, double s) const noexcept;
  // The next part of the path; false: it ends.
  [[nodiscard]] bool next_part(const CartesianPlan& plan) noexcept;
  void begin_part(const CartesianPlan& plan, double from) noexcept;
  [[nodiscard]] double first_end(const CartesianPlan& plan, double from) const noexcept;
  [[nodiscard]] bool may_bound(const CartesianPlan& plan) const noexcept;
  [[nodiscard]] SpanSample sample(const CartesianPlan& plan, double s, double speed, double way,
                                  const JointAngles& near) noexcept;
  void begin_interval(const CartesianPlan& plan) noexcept;
  [[nodiscard]] Found search(const CartesianPlan& plan) noexcept;
  [[nodiscard]] Found end_part(const CartesianPlan& plan) noexcept;
  [[nodiscard]] Found begin_way(const CartesianPlan& plan) noexcept;
  [[nodiscard]] Found check_way(const CartesianPlan& plan) noexcept;
  [[nodiscard]] Found check_interval(const CartesianPlan& plan) noexcept;
  void end_interval(const CartesianPlan& plan, double end_s, bool at_end_of_table) noexcept;
  [[nodiscard]] Found unknown_until(const CartesianPlan& plan, double t_s) noexcept;
  void add_spans(const CartesianPlan& plan, const SpanSample& middle, const SpanSample& end,
                 const SpanMisfit& misfit) noexcept;

  const Arm& arm_;
  SpanCheck check_;
  static constexpr std::size_t kDepth = 32;

  bool over_ = false;        // the rest of the plan is unknown
  double t_s_ = 0.0;         // up to here all is known or was said to be unknown
  std::size_t point_ = 0;    // of the table, the last one at or before t_s_
  std::size_t segment_ = 0;  // of the part; of a corner the first one
  bool in_corner_ = false;
  SmoothPart part_{};
  SpanSample last_{};                       // the search has come up to here
  std::array<SpanSample, kDepth> ahead_{};  // ends of ways that begin at the one before, the nearest last
  std::size_t ahead_count_ = 0;
  std::size_t stale_ = 0;            // the first ones ahead may be those of another branch
  std::array<PathSpan, 2> spans_{};  // to be checked
  std::size_t span_ = 0, span_count_ = 0;
  SpanMotion before_{};     // at the end of the interval before
  double break_s_ = 0.0;    // a time at which the law jumps; before t_s_: none
  bool joined_ = false;     // the present interval of the table is known to join it
  double longest_s_ = 0.0;  // that is tried
  double jerk_share_ = 0.0;
  PathCheck::Place excess_{};
  bool at_sample_ = false;
  int inverses_ = 0;
};

}  // namespace armature
