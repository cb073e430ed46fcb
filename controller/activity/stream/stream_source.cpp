#include "controller/activity/stream/stream_source.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/joint/axis_limits.hpp"
#include "controller/trajectory/state/axis_reach.hpp"

namespace armature {

void StreamSource::begin(const Request& request, const PerAxis<Radians>& position, Ticks tick) noexcept {
  const auto& first = request.get<StreamSample>();
  path_.begin(first);
  for (std::size_t i = 0; i < robot_.axis_count; ++i) {
    const AxisModel& axis = robot_.axes[i];
    axes_[i] = AxisFollower{
        first.profile, axis_limits(axis), {.least = axis.min_rad, .largest = axis.max_rad}, position[i].value()};
  }
  start_ = tick + first.delay;
  braking_ = complete_ = false;
  still_ticks_ = 0;
  result_ = {.tag = first.tag};
  set_point_ = {.position = position, .state = MotionState::kMoving};
}

void StreamSource::stop(StopKind how) noexcept {
  brake(StreamEnded::How::kStopped);
  if (how == StopKind::kQuick) brake_hard();
}

void StreamSource::feed(const Request& next) noexcept {
  const auto& sample = next.get<StreamSample>();
  // A set-point for which there is no room is missing later, and the stream is then late.
  const bool added = path_.add(sample);
  if (added && sample.kind == StreamSample::Kind::kLast) complete_ = true;
}

SetPoint& StreamSource::advance(Ticks tick, const RunControl::View&) noexcept {
  const Ticks time = tick - start_;
  if (!braking_ && !complete_ && time >= path_.newest()) brake(StreamEnded::How::kLate);
  bool moves = false;
  if (braking_) {
    const double t_s = seconds(Ticks{++braked_ticks_});
    for (std::size_t i = 0; i < robot_.axis_count; ++i) {
      set_point_.position[i] = Radians{stops_[i].at(t_s).position};
      moves = moves || t_s < stops_[i].duration_s();
    }
  } else {
    follow(time);
    moves = !complete_ || time < path_.newest();
    for (std::size_t i = 0; i < robot_.axis_count; ++i) moves = moves || !axes_[i].state().at_rest();
  }
  still_ticks_ = moves ? 0 : still_ticks_ + 1;
  set_point_.rate = moves ? 1.0 : 0.0;
  set_point_.state = braking_ ? MotionState::kStopping : MotionState::kMoving;
  set_point_.wake = still_ticks_ == 1;
  result_.tick = tick;
  if (over()) events_.on_event(result_);
  return set_point_;
}

void StreamSource::follow(Ticks time) noexcept {
  path_.move_to(time);
  ++result_.followed;
  for (std::size_t i = 0; i < robot_.axis_count; ++i) {
    const AxisModel& axis = robot_.axes[i];
    AxisState wanted = path_.state(i, time);
    const double position = wanted.position;
    if (!(position >= axis.min_rad && position <= axis.max_rad)) {
      wanted = {.position = std::clamp(position, axis.min_rad, axis.max_rad)};
    }
    axes_[i].advance(wanted);
    set_point_.position[i] = Radians{axes_[i].state().position};
    double& largest = result_.deviation_rad[i];
    if (time >= Ticks{0}) largest = std::max(largest, std::fabs(axes_[i].state().position - position));
  }
}

void StreamSource::brake(StreamEnded::How how) noexcept {
  if (braking_) return;
  braking_ = true;
  braked_ticks_ = 0;
  result_.how = how;
  for (std::size_t i = 0; i < robot_.axis_count; ++i) stops_[i] = axes_[i].stop();
}

// While braking.
void StreamSource::brake_hard() noexcept {
  const double t_s = seconds(Ticks{braked_ticks_});
  for (std::size_t i = 0; i < robot_.axis_count; ++i) {
    stops_[i] = plan_to_velocity(ProfileKind::kTrapezoid, stops_[i].at(t_s), 0.0, axis_limits(robot_.axes[i]));
  }
  braked_ticks_ = 0;
}

void StreamSource::cut_short(Ticks tick) noexcept {
  result_.how = StreamEnded::How::kFault;
  result_.tick = tick;
  events_.on_event(result_);
}

}  // namespace armature
