#include "controller/command/dispatcher.hpp"

#include <cassert>
#include <optional>
#include <type_traits>

#include "controller/command/move_checks.hpp"
#include "controller/motion/move_events.hpp"
#include "controller/trajectory/plan/joint_move.hpp"

namespace armature {

Dispatcher::Dispatcher(const RobotModel& robot, const Arm& arm, const PlanningConfig& config, Inboxes& inboxes,
                       MotionMailbox& mailbox, ToolIo& tool, EventListener& events) noexcept
    : robot_{robot},
      arm_{arm},
      config_{config},
      inboxes_{inboxes},
      mailbox_{mailbox},
      tool_{tool},
      events_{events},
      plane_{robot.arm, config.flange_T_tool},
      planner_{robot, arm, config.flange_T_tool, config.max_stretch},
      stream_{robot, arm, config, mailbox},
      frames_{config.base_T_user},
      conveyor_{robot, arm, config, mailbox} {
  joined().begin_joined();
  if (config.conveyor) frames_.back() = conveyor_.base_T_part();
}

bool Dispatcher::execute(RegisterBus& bus) noexcept {
  while (const std::optional<MotionNotice> notice = mailbox_.notices.try_pop()) on_notice(*notice);
  Inbox& program = inbox_of(inboxes_, Source::kProgram);
  const auto accept_next = [this](Inbox& inbox) {
    const std::optional<Command> command = inbox.try_pop();
    if (command) std::visit([this](const auto& content) { accept(content); }, *command);
    return command.has_value();
  };
  for (Inbox& inbox : inboxes_) {
    if (&inbox == &program && dropping_program_) drop_program();
    while ((&inbox != &program || !waiting_.full()) && accept_next(inbox)) {
    }
  }
  send_jog();
  send_retarget();
  const std::int64_t inverses = stream_.take_inverses() + conveyor_.take_inverses();
  if (inverses > 0) bus.charge(Work::kInverse, inverses);
  return execute_next(bus) || dropping_program_.has_value();
}

void Dispatcher::on_notice(const MotionNotice& notice) noexcept {
  switch (notice.kind) {
    case MotionNotice::Kind::kAtRest:
      if (notice.jogs != jogs_sent_ || next_jog_) return;  // the answer to a later jog command follows
      jogging_ = false;
      jog_ended_.reset();
      stream_.ended();
      conveyor_.left();
      settle_dropped_window(Refusal::kNotReady);
      if (mode_ == Mode::kFollowing) drop_moves(Refusal::kPartLost);
      mode_ = Mode::kReady;
      planned_end_ = notice.position;
      on_referenced(notice.referenced);
      return;
    case MotionNotice::Kind::kRetargeted:
      return on_retargeted(notice.position);
    case MotionNotice::Kind::kNotRetargeted:
      if (mode_ == Mode::kRetargeting) mode_ = Mode::kReady;
      return;
    case MotionNotice::Kind::kFaultPersists:
      refuse(Refusal::kNotReady, clear_tag_);
      mode_ = Mode::kFault;
      drop_moves();
      return;
    case MotionNotice::Kind::kFault:
      mode_ = Mode::kFault;
      jogging_ = homing_ = false;
      jog_ended_.reset();
      stream_.ended();
      conveyor_.left();
      next_jog_.reset();
      mailbox_.control.set_hold(false);  // no move is left to resume
      drop_moves();
      settle_dropped_window(Refusal::kNotReady);
      return;
    case MotionNotice::Kind::kUnusable:
      mode_ = Mode::kUnusable;
      drop_moves();
      return;
  }
}

template <class Move>
void Dispatcher::accept(const Move& move) noexcept {
  std::optional<MoveRefused> refusal;
  if (mode_ == Mode::kFault || mode_ == Mode::kUnusable) {
    refusal = MoveRefused{.reason = Refusal::kNotReady};
  } else if (!referenced_ && !homing_) {
    refusal = MoveRefused{.reason = Refusal::kNotReferenced};
  } else if constexpr (std::is_same_v<Move, JointMove>) {
    refusal = find_refusal(robot_, move);
  } else if constexpr (requires { find_refusal(move); }) {
    refusal = find_refusal(move);
  } else {
    refusal = find_refusal(robot_, frames_, move);
  }
  bool now = false;
  if constexpr (std::is_same_v<Move, JointMove>) {
    now = move.now;
    if (now && !refusal) refusal = accept_now(move);
  }
  const WaitingMove waiting{.move = move, .follows = !gap_, .retargets = retargets_accepted_};
  if (!refusal && !now && !push(waiting)) refusal = MoveRefused{.reason = Refusal::kQueueFull};
  // The moves before and after a refused move must not be blended, nor those before and after a move that does not
  // wait.
  gap_ = refusal || now;
  if (!refusal) return;
  refusal->tag = move.tag;
  events_.on_event(*refusal);
}

std::optional<MoveRefused> Dispatcher::accept_now(const JointMove& move) noexcept {
  if (jogging_ || homing_ || mode_ == Mode::kFollowing) return MoveRefused{.reason = Refusal::kNotReady};
  if (next_retarget_) refuse(Refusal::kReplaced, next_retarget_->tag);
  next_retarget_ = move;
  ++retargets_accepted_;
  return std::nullopt;
}

// Not inlined: g++ 12 would take the other members of the variant for read.
[[gnu::noinline]] bool Dispatcher::push(const WaitingMove& move) noexcept {
  return waiting_.try_push(move);
}

void Dispatcher::accept(const StreamPoint& point) noexcept {
  const bool expected = stream_.expects(point);
  if (!point.first && !expected) return;  // the end of the stream was reported
  std::optional<MoveRefused> refusal;
  if (!referenced_) {
    refusal = MoveRefused{.reason = Refusal::kNotReferenced};
  } else if (expected || rest()) {
    refusal = stream_.send(point, planned_end_);
  } else {
    refusal = MoveRefused{.reason = Refusal::kNotReady};
  }
  if (refusal) {
    refusal->tag = point.tag;
    return events_.on_event(*refusal);
  }
  mode_ = Mode::kAwaitingRest;
}

void Dispatcher::accept(const Hold&) noexcept {
  end_jog(VelocityCommand::Kind::kHalt);
  end_homing();
  stream_.stop(StreamSample::Kind::kStop);
  lose_part();
  mailbox_.control.set_hold(true);
}

void Dispatcher::accept(const Resume&) noexcept {
  mailbox_.control.set_hold(false);
}

void Dispatcher::accept(const SetOverride& wanted) noexcept {
  if (std::optional<MoveRefused> refusal = find_refusal(wanted)) {
    refusal->tag = wanted.tag;
    events_.on_event(*refusal);
  } else {
    mailbox_.control.set_share(wanted.share);
  }
}

void Dispatcher::accept(const Stop& stop) noexcept {
  const bool soft = stop.kind == Stop::Kind::kSoft, moves = mode_ == Mode::kReady || mode_ == Mode::kRetargeting;
  // A quick stop that is braking stays one.
  if (!soft || moves) mailbox_.control.set_soft_stop(soft);
  drop_moves();
  end_jog(soft ? VelocityCommand::Kind::kSoftStop : VelocityCommand::Kind::kStop);
  end_homing();
  stream_.stop(soft ? StreamSample::Kind::kStop : StreamSample::Kind::kQuickStop);
  lose_part(Refusal::kNotReady);
  if (!soft) conveyor_.stop_leaving();
  if (moves) order(MotionOrder::kStop);
  mailbox_.control.set_hold(false);
}

void Dispatcher::accept(const ClearFault& clear) noexcept {
  if (mode_ == Mode::kFault) {
    clear_tag_ = clear.tag;
    order(MotionOrder::kClearFault);
  }
  if (mode_ == Mode::kUnusable) refuse(Refusal::kNotReady, clear.tag);
}

void Dispatcher::accept(const SwitchOff& off) noexcept {
  if (rest()) {
    order(MotionOrder::kSwitchOff);
  } else {
    refuse(Refusal::kNotReady, off.tag);
  }
}

void Dispatcher::order(MotionOrder order) noexcept {
  [[maybe_unused]] const bool pushed = mailbox_.orders.try_push(order);
  assert(pushed);  // never full, see MotionMailbox
  mode_ = Mode::kAwaitingRest;
}

void Dispatcher::send_retarget() noexcept {
  if (!next_retarget_ || mode_ != Mode::kReady) return;
  const JointMove& move = *next_retarget_;
  [[maybe_unused]] const bool pushed = mailbox_.retargets.try_push(
      {.target = move.target, .speed = move.speed, .accel = move.accel, .kind = move.profile, .tag = move.tag});
  assert(pushed);  // the one before was answered, or dropped by an order or a fault that was answered
  ++plans_sent_;
  retarget_sent_ = retargets_accepted_;
  next_retarget_.reset();
  mode_ = Mode::kRetargeting;
}

// Drops the moves that came before. In another mode a Stop or a fault has done so, and the rest is reported later.
void Dispatcher::on_retargeted(const PerAxis<Radians>& target) noexcept {
  if (mode_ != Mode::kRetargeting) return;
  mode_ = Mode::kReady;
  planned_end_ = target;
  drop_chain(Refusal::kReplaced);
  settle_dropped_window(Refusal::kReplaced);
  dropping_program_ = Refusal::kReplaced;
  while (const WaitingMove* waiting = waiting_.front()) {
    if (static_cast<std::int32_t>(waiting->retargets - retarget_sent_) >= 0) break;
    drop_first_waiting(Refusal::kReplaced);
  }
}

void Dispatcher::drop_moves(Refusal reason) noexcept {
  drop_chain(reason);
  drop_waiting(reason);
  if (next_retarget_) refuse(reason, next_retarget_->tag);
  next_retarget_.reset();
  dropping_program_ = reason;
}

// Until the inbox is found empty: more may wait in the memory that the host fills.
void Dispatcher::drop_program() noexcept {
  bool any = false;
  while (const std::optional<Command> command = inbox_of(inboxes_, Source::kProgram).try_pop()) {
    any = true;
    const auto refuse_it = [this](const auto& content) {
      if constexpr (requires { content.tag; }) refuse(*dropping_program_, content.tag);
    };
    std::visit(refuse_it, *command);
  }
  if (!any) dropping_program_.reset();
}

// Also ends a wait for an input.
void Dispatcher::drop_chain(Refusal reason) noexcept {
  planner_.cancel();
  unasked_stop_ = false;
  departure_.reset();
  arrival_.reset();
  // Core 0 reports the moves that it has.
  const std::size_t sent = window_ == Window::kSent ? window_moves_ : 0;
  for (std::size_t move = 0; move < moves_in(joined()); ++move) refuse(reason, tag_of(joined(), move));
  joined().begin_joined();
  for (std::size_t move = 0; move < joints_.count; ++move) refuse(reason, joints_.moves[move].tag);
  joints_.count = 0;
  for (const SegmentRequest& request : chain_.requests().subspan(sent)) refuse(reason, request.tag);
  if (window_ == Window::kSent) {
    window_ = Window::kDropped;
  } else if (window_ != Window::kDropped) {
    close_window();
    chain_.clear();
  }
  chain_on_conveyor_ = false;
  conveyor_.ended();
  tool_.cancel();
}

void Dispatcher::drop_waiting(Refusal reason) noexcept {
  while (!waiting_.empty()) drop_first_waiting(reason);
}

void Dispatcher::drop_first_waiting(Refusal reason) noexcept {
  refuse(reason, std::visit([](const auto& move) { return move.tag; }, waiting_.front()->move));
  waiting_.drop_front();
}

void Dispatcher::refuse(Refusal reason, Tag tag) noexcept {
  events_.on_event(MoveRefused{.reason = reason, .tag = tag});
}

}  // namespace armature
