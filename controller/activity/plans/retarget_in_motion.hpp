// The joint move that begins at once, planned over several ticks while the present plan goes on.
//
// A tick has no time for the whole plan. So the sampler first computes kMost set-points ahead: three in one tick of a
// joint plan, and one in each of three ticks of a path, whose inverse kinematics take longer. The new move begins in
// the state of motion at the last of them. While they are executed it is planned, a part in each tick. It begins 4
// ticks after its request on a joint plan or at rest, and 6 ticks after it on a path. The rate does not change
// meanwhile, unless a change that limits the jerk must first end.
#pragma once

#include <optional>

#include "controller/activity/plans/steps_ahead.hpp"
#include "controller/trajectory/joint/retarget_planner.hpp"
#include "controller/trajectory/run/sampler.hpp"

namespace armature {

class RetargetInMotion {
 public:
  // References must outlive the object.
  RetargetInMotion(const RobotModel& robot, Sampler& sampler) noexcept : sampler_{sampler}, planner_{robot} {}

  // Once; then next() is called in each tick until ready().
  void begin(const RetargetGoal& goal) noexcept;
  // It begins in the state of motion of the sampler, in this tick; planned() is valid until the next begin().
  [[nodiscard]] bool ready() const noexcept { return phase_ == Phase::kPlans && planner_.done() && ahead_.empty(); }
  [[nodiscard]] const RetargetPlanner& planned() const noexcept { return planner_; }
  // Neither planned nor ready; what was computed ahead remains.
  void end() noexcept { phase_ = Phase::kNone; }
  void reset() noexcept {
    end();
    ahead_.clear();
  }
  // No other plan may begin or continue the present one.
  [[nodiscard]] bool active() const noexcept { return phase_ != Phase::kNone || !ahead_.empty(); }
  // The sampler is at the step of the last next().
  [[nodiscard]] bool in_step() const noexcept { return ahead_.empty(); }

  // The step of this tick: from those ahead, or that of `advance`, which calls the sampler. Then it plans.
  template <class Advance>
  [[nodiscard]] StepsAhead::Step next(Advance advance) noexcept {
    inverses_ = 0;
    worked_ = false;
    if (!ahead_.empty()) {
      const StepsAhead::Step step = ahead_.pop();
      work();
      return step;
    }
    advance();
    inverses_ = sampler_.inverses();
    const StepsAhead::Step step = StepsAhead::step_of(sampler_);
    work();
    return step;
  }
  // Of the last next(): inverse kinematics computed, and whether a part of a plan was.
  [[nodiscard]] int inverses() const noexcept { return inverses_; }
  [[nodiscard]] bool worked() const noexcept { return worked_; }

 private:
  enum class Phase { kNone, kLooksAhead, kPlans };
  // Inverse kinematics of a tick for which there is time.
  static constexpr int kMostInverses = 2;

  void work() noexcept;
  void look_ahead() noexcept;

  Sampler& sampler_;
  RetargetPlanner planner_;
  RetargetGoal goal_{};
  StepsAhead ahead_;
  Phase phase_ = Phase::kNone;
  int inverses_ = 0;
  bool worked_ = false;
};

}  // namespace armature
