#include "controller/motion/plans_or_jog.hpp"

namespace armature {
namespace {

// A set is committed in one tick, starts with the next trigger, and is complete at the one after.
constexpr int kTicksToEmit = 2;

}  // namespace

PlansOrJog::PlansOrJog(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool, MotionMailbox& mailbox,
                       EventListener& events) noexcept
    : mailbox_{mailbox},
      input_{mailbox},
      plans_{robot, arm, mailbox, events},
      velocity_{robot, arm, input_, {.time_out = Ticks{1}, .flange_T_tool = flange_T_tool}} {}

const SetPoint& PlansOrJog::advance(Ticks tick) noexcept {
  if (!jogging_ && !mailbox_.jogs.empty()) {
    velocity_.reset_to(plans_.last().position);
    jogging_ = true;
    still_ticks_ = 0;
  }
  if (jogging_) {
    jog(tick);
  } else {
    set_point_ = plans_.advance(tick);
  }
  return set_point_;
}

void PlansOrJog::jog(Ticks tick) noexcept {
  const std::uint32_t before = mailbox_.jogs_accepted;
  set_point_ = velocity_.advance(tick);
  set_point_.stopped = false;
  set_point_.wake = set_point_.wake || mailbox_.wake_each_tick.load(std::memory_order_relaxed);
  const bool still = velocity_.done() && mailbox_.jogs_accepted == before;
  still_ticks_ = still ? still_ticks_ + 1 : 0;
  if (still_ticks_ < kTicksToEmit) return;
  plans_.reset_to(set_point_.position);
  jogging_ = false;
  set_point_.stopped = true;
}

void PlansOrJog::reset_to(const PerAxis<Radians>& position) noexcept {
  plans_.reset_to(position);
  jogging_ = false;
  set_point_ = plans_.last();
}

void PlansOrJog::cut_short(Ticks tick) noexcept {
  if (!jogging_) plans_.cut_short(tick);
}

void PlansOrJog::cancel(Ticks tick) noexcept {
  (void)input_.latest();
  if (jogging_) reset_to(set_point_.position);
  plans_.cancel(tick);
  set_point_ = plans_.last();
}

Stopping PlansOrJog::stopping() const noexcept {
  return jogging_ ? velocity_.stopping() : plans_.stopping();
}

}  // namespace armature
