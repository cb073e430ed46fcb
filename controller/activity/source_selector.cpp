#include "controller/activity/source_selector.hpp"

#include <utility>

namespace armature {

SourceSelector::SourceSelector(const RobotModel& robot, const Arm& path_arm, const Arm& arm,
                               const Transform& flange_T_tool, Channel& channel, EventListener& events,
                               LogicPort& logic, const BeltParts& belt) noexcept
    : channel_{channel}, own_{robot, path_arm, arm, flange_T_tool, channel, events, logic, belt} {
  last_ = &own_.plans.set_point();
}

const SetPoint& SourceSelector::advance(Ticks tick) noexcept {
  // Read before the requests: when a released hold is seen here, the stop that released it is in the queue.
  const RunControl::View control = channel_.control.view();
  for_each([tick](ActivitySource& source) { source.observe(tick); });
  read_requests(tick);
  SetPoint& next = owner_->advance(tick, control);
  last_ = &next;
  next.wake = next.wake || channel_.loop.wake_each_tick.load(std::memory_order_relaxed);
  next.stopped = next.stopped || std::exchange(late_stop_, false);
  if (owner_ != &own_.plans && owner_->over()) {
    next.stopped = true;
    give_back_to_plans(next.position);
  }
  return next;
}

void SourceSelector::read_requests(Ticks tick) noexcept {
  for (const Request* next = channel_.requests.front(); next != nullptr; next = channel_.requests.front()) {
    channel_.loop.number = next->number;
    late_stop_ = !give(*next, tick) || late_stop_;
    channel_.requests.drop_front();
  }
}

bool SourceSelector::give(const Request& request, Ticks tick) noexcept {
  ActivitySource* const source = sources_[static_cast<std::size_t>(request.to)];
  if (source == nullptr) return true;  // no activity of core 1 does that
  if (request.kind == Request::Kind::kStop) {
    if (source != owner_) return false;
    source->stop(request.stop);
  } else if (source == owner_) {
    source->feed(request);
  } else if (request.kind == Request::Kind::kBegin && owner_ == &own_.plans) {
    source->begin(request, last_->position, tick);
    owner_ = source;
  } else {
    source->drop(request);  // it came when the motion was over
  }
  return true;
}

void SourceSelector::give_back_to_plans(const PerAxis<Radians>& position) noexcept {
  owner_ = &own_.plans;
  own_.plans.reset_to(position);
}

void SourceSelector::reset_to(const PerAxis<Radians>& position) noexcept {
  for_each([&](ActivitySource& source) { source.reset_to(position); });
  owner_ = &own_.plans;
  last_ = &own_.plans.set_point();
}

void SourceSelector::cut_short(Ticks tick) noexcept {
  owner_->cut_short(tick);
  if (owner_ != &own_.plans) reset_to(owner_->set_point().position);
}

void SourceSelector::cancel(Ticks tick) noexcept {
  for_each([tick](ActivitySource& source) { source.cancel(tick); });
  for (const Request* next = channel_.requests.front(); next != nullptr && !is_order(*next);
       next = channel_.requests.front()) {
    channel_.loop.number = next->number;
    if (ActivitySource* source = sources_[static_cast<std::size_t>(next->to)]) source->drop(*next);
    channel_.requests.drop_front();
  }
  last_ = &own_.plans.set_point();
}

SetPointSource::Order SourceSelector::take_order() noexcept {
  const Request* next = channel_.requests.front();
  if (next == nullptr || !is_order(*next)) return Order::kNone;
  const bool clears = next->kind == Request::Kind::kClearFault;
  channel_.loop.number = next->number;
  channel_.requests.drop_front();
  return clears ? Order::kClearFault : Order::kSwitchOff;
}

}  // namespace armature
