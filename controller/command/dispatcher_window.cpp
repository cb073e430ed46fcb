// The planning of a long chain in windows.
//
// A window is planned late, so that it has many moves, but not too late: the arm must not brake before it is there.
// PlanningCost estimates the time that its planning takes. At the begin of a chain there is little time, so the first
// windows are small. Where core 1 cannot plan as fast as the tool moves, a window continues the present plan while that
// brakes already, so the tool becomes slower and does not stop. A plan that comes too late all the same does no harm:
// core 0 executes the old one to its stop, and the moves are planned again from there. The same is done with moves that
// cannot continue the plan, and it tells why if they cannot be executed at all.
#include <algorithm>

#include "controller/command/dispatcher.hpp"
#include "controller/trajectory/plan/path_layout.hpp"

namespace armature {
namespace {

// For the reaction of both cores.
constexpr double kReactionTicks = 20.0;
// The planning may take so many times as long as expected.
constexpr double kMargin = 1.5;
// A window has so many moves more than the one before, unless there are no more or no time for more.
constexpr std::size_t kLeastMoves = 64, kFewestMoves = 8;
// Of the time until the arm rests: a window that begins later gains little.
constexpr double kLatestShare = 0.8;

}  // namespace

bool Dispatcher::execute_window(RegisterBus& bus) noexcept {
  if (window_ == Window::kSent) return await_window();
  if (window_ != Window::kOpen) return false;
  if (chain_.empty() && stands()) {
    close_window();
    return true;
  }
  collect_for_window();
  switch (planner_.progress()) {
    case CartesianPlanner::Progress::kWorking:
      work_on_chain(bus);
      return true;
    case CartesianPlanner::Progress::kRefused:
      close_window();
      return true;
    case CartesianPlanner::Progress::kDone:
    case CartesianPlanner::Progress::kIdle:
      break;
  }
  if (window_moves_ > 0) {
    measure_planning(bus);
    send_plan(planner_.plan());
    window_ = Window::kSent;
    return true;
  }
  if (!chain_.empty()) return continue_window(bus);
  if (waiting_.empty()) return false;
  close_window();  // something else follows
  return true;
}

// The moves behind one that was refused, which continue it.
void Dispatcher::drop_rest_of_chain() noexcept {
  while (dropping_chain_) {
    const CartesianMove* move = next_of_chain();
    if (move == nullptr) {
      dropping_chain_ = waiting_.empty() && !inbox_of(inboxes_, Source::kProgram).empty();
      return;
    }
    refuse(Refusal::kChainRefused, move->tag);
    dropping_chain_ = move->blend_mm > 0.0;
    waiting_.drop_front();
  }
}

void Dispatcher::collect_for_window() noexcept {
  while (true) {
    const CartesianMove* move = next_of_chain();
    if (move == nullptr || !may_continue(*move) || !planner_.may_add(move->profile) ||
        !chain_.goes_on_with(*move, frames_, plane_)) {
      return;
    }
    if (chain_.empty()) in_time_ = !is_braking();
    chain_.add(*move, frames_, plane_);
    waiting_.drop_front();
  }
}

// Begins with the planning of a window, or waits.
bool Dispatcher::continue_window(RegisterBus& bus) noexcept {
  const MotionMailbox::PlanProgress::View progress = mailbox_.progress.view();
  if (stands()) {
    close_late_window();
    return true;
  }
  if (progress.plan != plans_queued_) return false;  // it has not begun
  const auto duration = static_cast<double>(planner_.plan().duration.value());
  const double now = progress.ticks, end = now + kLatestShare * (duration - now);
  const double brakes = planner_.continue_before_s() / kTickSeconds;
  // A window of as many moves as it can have is planned in time.
  constexpr auto kMost = static_cast<double>(CartesianPlan::kMaxSegments);
  const std::size_t there = chain_.requests().size();
  const double of_each = there > 0 ? expected_ticks(there) / static_cast<double>(there) : 0.0;
  if (now + 2.0 * (kReactionTicks + kMost * of_each) < brakes) return false;

  // For the moves of the present plan that are not over at about `tick`. They are planned again.
  const auto left = [&](double tick) {
    const std::size_t segments = planner_.segments_left(Ticks{static_cast<std::int64_t>(tick)});
    return kMargin * planning_cost_.ticks(duration - tick, static_cast<double>(segments));
  };
  // As many as can be planned before the arm brakes, or a few before it almost rests.
  const double time = brakes - now - kReactionTicks - left(brakes);
  std::size_t wanted = std::min(kFewestMoves, there);
  while (wanted < there && expected_ticks(wanted + 1) <= time) ++wanted;
  // When the window can be there, if it begins at about `tick`.
  const auto ready = [&](double tick) { return now + kReactionTicks + left(tick) + expected_ticks(wanted); };
  const double begin = ready(ready(brakes));
  // A later one leaves more time, and less of the present plan to plan again.
  const Ticks earliest{static_cast<std::int64_t>(std::max(begin, brakes - kReactionTicks))};
  if (begin > end) {
    if (now + kReactionTicks + left(end) > end) close_late_window();
    return window_ == Window::kNone;
  }
  const std::size_t moves =
      std::min({wanted, planner_.room(earliest), chain_.count_with_outputs(planner_.room_for_outputs(earliest))});
  const bool all = waiting_.empty() && inbox_of(inboxes_, Source::kProgram).empty();
  const bool in_haste = 1.2 * (begin - now) >= brakes - now;
  // A stop for want of room, as for more outputs than a plan can have, is not one for want of time.
  if (moves == 0 && now + kReactionTicks >= brakes) in_time_ = false;
  if (moves == 0 || (moves < kLeastMoves && !all && !in_haste)) return false;
  window_moves_ = moves;
  plan_begun_ = bus.now();
  if (!planner_.extend(earliest, chain_.blend_before_mm(), chain_.requests().first(window_moves_))) {
    close_late_window();
    return true;
  }
  bus.charge(Work::kPlan);
  return true;
}

// For the first moves of chain_.
double Dispatcher::expected_ticks(std::size_t moves) const noexcept {
  return kMargin * planning_cost_.ticks(chain_.least_s(moves) / kTickSeconds, static_cast<double>(moves));
}

void Dispatcher::measure_planning(RegisterBus& bus) noexcept {
  const auto cycles = static_cast<double>((bus.now() - plan_begun_).value());
  planning_cost_.measure(cycles / static_cast<double>(kTickCycles.value()), planner_, window_moves_);
}

// Waits until core 0 has begun with the window, or dropped it because it came too late.
bool Dispatcher::await_window() noexcept {
  if (mailbox_.plans_late.load(std::memory_order_acquire) != plans_late_) {
    ++plans_late_;
    close_late_window();
    return true;
  }
  if (mailbox_.progress.view().plan != plans_queued_) return false;
  planned_end_ = planner_.plan().target;
  chain_.drop_front(window_moves_);
  window_moves_ = 0;
  open_window();
  return true;
}

// The moves of chain_ are those that the sent plan has no room for.
void Dispatcher::open_window() noexcept {
  window_ = Window::kOpen;
  in_time_ = true;
}

// The present plan, which can be continued, is near its end: another one that continues it would come late.
bool Dispatcher::is_braking() const noexcept {
  const MotionMailbox::PlanProgress::View progress = mailbox_.progress.view();
  return progress.plan == plans_queued_ && progress.ticks >= planner_.continue_before_s() / kTickSeconds;
}

// The moves of chain_ are planned from the end of the last plan that core 0 has accepted.
void Dispatcher::close_window() noexcept {
  if (window_ == Window::kNone) return;
  planner_.cancel();
  window_ = Window::kNone;
  window_moves_ = 0;
}

// The same, because no plan was there in time that continues the present one.
void Dispatcher::close_late_window() noexcept {
  unasked_stop_ = in_time_;
  close_window();
}

// Core 0 has ended both plans. If it had dropped the second one before, it has not reported the moves of that.
void Dispatcher::settle_dropped_window(Refusal reason) noexcept {
  if (window_ != Window::kDropped) return;
  if (mailbox_.plans_late.load(std::memory_order_acquire) != plans_late_) {
    ++plans_late_;
    for (const SegmentRequest& request : chain_.requests().first(window_moves_)) refuse(reason, request.tag);
  }
  close_window();
  chain_.clear();
}

}  // namespace armature
