#include "controller/command/dispatcher.hpp"

#include <cassert>
#include <cmath>
#include <variant>

#include "controller/trajectory/joint_move.hpp"

namespace armature {

std::optional<MoveRefusal> find_refusal(const RobotModel& robot, const JointMove& move) noexcept {
  // Written so that a NaN fails every test.
  if (!(move.speed > 0.0 && move.speed <= 1.0)) return MoveRefusal{.reason = Refusal::kInvalidTarget};
  for (std::uint8_t axis = 0; axis < kAxes; ++axis) {
    const double target_rad = move.target[axis].value();
    const AxisModel& model = robot.axes[axis];
    const auto number = static_cast<std::uint8_t>(axis + 1);
    if (!std::isfinite(target_rad)) return MoveRefusal{.reason = Refusal::kInvalidTarget, .axis = number};
    if (target_rad < model.min_rad || target_rad > model.max_rad) {
      return MoveRefusal{.reason = Refusal::kOutsideLimits, .axis = number};
    }
  }
  return std::nullopt;
}

Dispatcher::Dispatcher(const RobotModel& robot, SyncRule sync, Inbox& inbox, MotionMailbox& mailbox,
                       ControllerObserver& observer) noexcept
    : robot_{robot}, sync_{sync}, inbox_{inbox}, mailbox_{mailbox}, observer_{observer} {}

void Dispatcher::run(RegisterBus& bus) noexcept {
  while (bus.wait_for_interrupt(Interrupts::kEvent) != Interrupts::kNone) serve(bus);
}

void Dispatcher::serve(RegisterBus& bus) noexcept {
  bool working = true;
  while (working) {
    working = false;
    while (const std::optional<MotionNews> news = mailbox_.news.try_pop()) hear(*news);
    // All commands before the next plan, so that a Stop is not held up by planning.
    while (const std::optional<Command> command = inbox_.try_pop()) {
      std::visit([this](const auto& content) { take(content); }, *command);
    }
    if (mode_ != Mode::kReady || mailbox_.plans.full()) continue;
    if (const std::optional<JointMove> move = waiting_.try_pop()) {
      const JointPlan plan = plan_joint_move(robot_, planned_end_, move->target, move->speed, sync_);
      bus.charge(Work::kPlan);
      working = true;
      if (plan.duration > kLongestMove) {
        refuse(Refusal::kInvalidTarget);
        continue;
      }
      planned_end_ = plan.target;
      (void)mailbox_.plans.try_push(plan);
    }
  }
}

void Dispatcher::hear(const MotionNews& news) noexcept {
  switch (news.kind) {
    case MotionNews::Kind::kAtRest:
      mode_ = Mode::kReady;
      planned_end_ = news.position;
      return;
    case MotionNews::Kind::kFaultStays:
      refuse(Refusal::kNotReady);  // the ClearFault
      [[fallthrough]];
    case MotionNews::Kind::kFault:
      mode_ = Mode::kFault;
      drop_waiting();
      return;
    case MotionNews::Kind::kUnusable:
      mode_ = Mode::kUnusable;
      drop_waiting();
      return;
  }
}

void Dispatcher::take(const JointMove& move) noexcept {
  if (mode_ == Mode::kFault || mode_ == Mode::kUnusable) {
    refuse(Refusal::kNotReady);
  } else if (const std::optional<MoveRefusal> refusal = find_refusal(robot_, move)) {
    observer_.on_move_refused(*refusal);
  } else if (!waiting_.try_push(move)) {
    refuse(Refusal::kQueueFull);
  }
}

void Dispatcher::take(const Stop&) noexcept {
  drop_waiting();
  if (mode_ == Mode::kReady) order(MotionOrder::kStop);
}

void Dispatcher::take(const ClearFault&) noexcept {
  if (mode_ == Mode::kFault) order(MotionOrder::kClearFault);
  if (mode_ == Mode::kUnusable) refuse(Refusal::kNotReady);
}

void Dispatcher::order(MotionOrder order) noexcept {
  [[maybe_unused]] const bool pushed = mailbox_.orders.try_push(order);
  assert(pushed);  // never full, see MotionMailbox
  mode_ = Mode::kAwaitingRest;
}

void Dispatcher::drop_waiting() noexcept {
  while (waiting_.try_pop()) refuse(Refusal::kNotReady);
}

void Dispatcher::refuse(Refusal reason) noexcept {
  observer_.on_move_refused({.reason = reason});
}

}  // namespace armature
