#include "controller/activity/plans/stages/window_stage.hpp"

#include <algorithm>

#include "controller/trajectory/cartesian/path_layout.hpp"

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

bool WindowStage::work(RegisterBus& bus) noexcept {
  if (state_ == State::kSent) return await_start();
  if (state_ != State::kOpen) return false;
  if (path_.empty() && outbox_.stands()) {
    close();
    return true;
  }
  collect();
  switch (path_.planner().progress()) {
    case PathStage::Progress::kWorking:
      path_.work(bus);
      return true;
    case PathStage::Progress::kRefused:
      // Such an output stops the tool, see PATHS.md.
      if (path_.planner().problem().kind == PathProblem::Kind::kOutputOutside) in_time_ = false;
      close_at_stop();
      return true;
    case PathStage::Progress::kDone:
    case PathStage::Progress::kIdle:
      break;
  }
  if (moves_ > 0) {
    path_.measure(moves_, bus);
    outbox_.send(path_.planner().plan());
    state_ = State::kSent;
    return true;
  }
  if (!path_.empty()) return start_planning(bus);
  if (context_.queue.empty()) return false;
  close();  // something else follows
  return true;
}

void WindowStage::collect() noexcept {
  while (true) {
    const CartesianMove* move = path_.next();
    if (move == nullptr || !may_continue(*move) || !path_.planner().may_add(move->profile) ||
        !path_.continues_with(*move)) {
      return;
    }
    if (path_.empty()) in_time_ = !is_braking();
    path_.take(*move);
  }
}

// Starts the planning of a window, or waits.
bool WindowStage::start_planning(RegisterBus& bus) noexcept {
  const double now = outbox_.ticks_of_last();
  if (outbox_.stands()) {
    close_at_stop();
    return true;
  }
  if (now < 0.0) return false;  // the plan has not started
  CartesianPlanner& planner = path_.planner();
  const PathRequests& requests = path_.requests();
  const auto duration = static_cast<double>(planner.plan().duration.value());
  const double end = now + kLatestShare * (duration - now);
  const double brakes = planner.continue_before_s() / kTickSeconds;
  // A window of as many moves as it can have is planned in time.
  constexpr auto kMax = static_cast<double>(CartesianPlan::kMaxSegments);
  const std::size_t there = requests.requests().size();
  const double of_each = there > 0 ? expected_ticks(there) / static_cast<double>(there) : 0.0;
  if (now + 2.0 * (kReactionTicks + kMax * of_each) < brakes) return false;

  // For the moves of the present plan that are not over at about `tick`. They are planned again.
  const auto left = [&](double tick) {
    const std::size_t segments = planner.segments_left(Ticks{static_cast<std::int64_t>(tick)});
    return kMargin * path_.cost().ticks(duration - tick, static_cast<double>(segments));
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
    if (now + kReactionTicks + left(end) > end) close_at_stop();
    return state_ == State::kNone;
  }
  const std::size_t moves =
      std::min({wanted, planner.room(earliest), requests.count_with_outputs(planner.room_for_outputs(earliest))});
  const bool all = !context_.queue.more_wait();
  const bool in_haste = 1.2 * (begin - now) >= brakes - now;
  // A stop for want of room, as for more outputs than a plan can have, is not one for want of time.
  if (moves == 0 && now + kReactionTicks >= brakes) in_time_ = false;
  if (moves == 0 || (moves < kLeastMoves && !all && !in_haste)) return false;
  moves_ = moves;
  path_.start_clock(bus);
  if (!planner.extend(earliest, requests.blend_before_mm(), requests.requests().first(moves_))) {
    close_at_stop();
    return true;
  }
  bus.charge(Work::kWindow);
  return true;
}

// For the first moves of the path.
double WindowStage::expected_ticks(std::size_t moves) const noexcept {
  const double least_ticks = path_.requests().least_s(moves) / kTickSeconds;
  return kMargin * path_.cost().ticks(least_ticks, static_cast<double>(moves));
}

// Waits until core 0 has started the window, or dropped it because it came too late.
bool WindowStage::await_start() noexcept {
  if (outbox_.take_late()) {
    close_at_stop();
    return true;
  }
  if (outbox_.ticks_of_last() < 0.0) return false;
  context_.owner.set_end(path_.planner().plan().target);
  path_.requests().drop_front(moves_);
  moves_ = 0;
  open();
  return true;
}

void WindowStage::open() noexcept {
  state_ = State::kOpen;
  in_time_ = true;
}

// The present plan, which can be continued, is near its end: another one that continues it would come late.
bool WindowStage::is_braking() const noexcept {
  const double ticks = outbox_.ticks_of_last();
  return ticks >= 0.0 && ticks >= path_.planner().continue_before_s() / kTickSeconds;
}

// The moves of the path are planned from the end of the last plan that core 0 has accepted.
void WindowStage::close() noexcept {
  if (state_ == State::kNone) return;
  path_.planner().cancel();
  state_ = State::kNone;
  moves_ = 0;
}

// The same, because no plan continues the present one: it came late, or the planner refused it.
void WindowStage::close_at_stop() noexcept {
  path_.set_unasked_stop(in_time_);
  close();
}

// Core 0 reports the moves that it has.
void WindowStage::drop(Refusal why) noexcept {
  path_.drop(why, state_ == State::kSent ? moves_ : 0);
  if (state_ == State::kSent) {
    state_ = State::kDropped;
  } else if (state_ != State::kDropped) {
    close();
    path_.clear();
  }
}

void WindowStage::settle(Refusal why) noexcept {
  if (state_ != State::kDropped) return;
  if (outbox_.take_late()) {
    for (const SegmentRequest& request : path_.requests().requests().first(moves_)) {
      context_.events.on_event(refused(why, request.tag));
    }
  }
  close();
  path_.clear();
}

}  // namespace armature
