#include "controller/activity/homing/homing_source.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "controller/base/timebase.hpp"

namespace armature {
namespace {

constexpr std::uint8_t bit(std::size_t axis) {
  return static_cast<std::uint8_t>(1u << axis);
}

void clear(std::uint8_t& mask, std::uint8_t bits) {
  mask = static_cast<std::uint8_t>(mask & ~bits);
}

}  // namespace

HomingSource::HomingSource(const RobotModel& robot, LogicPort& logic, EventListener& events) noexcept
    : robot_{robot}, logic_{logic}, events_{events}, axes_{make_per_axis([&](std::size_t axis) {
        return AxisHoming{robot.axes[axis]};
      })} {}

void HomingSource::begin(const Request& first, const PerAxis<Radians>& position, Ticks) noexcept {
  request_ = first.get<HomingRequest>();
  waiting_ = request_.axes;
  active_ = homed_ = 0;
  over_ = stopped_ = false;
  set_point_ = {.position = position, .state = MotionState::kMoving, .homing = request_.axes};
}

SetPoint& HomingSource::advance(Ticks tick, const RunControl::View&) noexcept {
  set_point_.planned = set_point_.wake = false;
  if (active_ == 0 && waiting_ != 0) begin_next_order(tick);
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    if ((active_ & bit(axis)) != 0) advance_axis(axis, tick);
  }
  set_point_.rate = active_ != 0 ? 1.0 : 0.0;
  if (active_ == 0 && waiting_ == 0) finish();
  return set_point_;
}

void HomingSource::begin_next_order(Ticks tick) noexcept {
  std::uint8_t order = std::numeric_limits<std::uint8_t>::max();
  const auto for_each_waiting = [&](auto action) {
    for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
      const auto& homing = robot_.axes[axis].homing;
      if ((waiting_ & bit(axis)) != 0 && homing) action(axis, homing->order);
    }
  };
  for_each_waiting([&](std::size_t, std::uint8_t own) { order = std::min(order, own); });
  for_each_waiting([&](std::size_t axis, std::uint8_t own) {
    if (own != order) return;
    axes_[axis].begin(set_point_.position[axis]);
    begun_[axis] = tick;
    active_ = static_cast<std::uint8_t>(active_ | bit(axis));
    events_.on_event(HomingStarted{.tag = request_.tag, .axis = static_cast<std::uint8_t>(axis + 1), .tick = tick});
  });
  clear(waiting_, active_);
}

void HomingSource::advance_axis(std::size_t index, Ticks tick) noexcept {
  AxisHoming& axis = axes_[index];
  axis.advance(sensors(index));
  set_point_.position[index] = axis.position();
  set_point_.planned = set_point_.planned || axis.planned();
  if (!axis.over()) return;
  clear(active_, bit(index));
  report_end(index, axis.how(), tick);
  if (axis.how() != HomingEnd::kHomed) return brake();
  homed_ = static_cast<std::uint8_t>(homed_ | bit(index));
}

HomingSensors HomingSource::sensors(std::size_t axis) noexcept {
  const LogicInput& input = logic_.last();
  const auto shows = [axis](std::uint8_t mask) { return (mask & bit(axis)) != 0; };
  HomingSensors sensors{.position = input.encoder[axis],
                        .home = shows(input.switches.home),
                        .limit_pos = shows(input.switches.limit_pos),
                        .limit_neg = shows(input.switches.limit_neg)};
  if (axes_[axis].wants_index()) sensors.index = logic_.index(axis);
  return sensors;
}

void HomingSource::stop(StopKind) noexcept {
  if (!std::exchange(stopped_, true)) brake();
}

void HomingSource::brake() noexcept {
  waiting_ = 0;
  set_point_.state = MotionState::kStopping;
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    if ((active_ & bit(axis)) != 0) axes_[axis].stop();
  }
}

void HomingSource::finish() noexcept {
  over_ = true;
  set_point_.state = MotionState::kIdle;
  set_point_.located = homed_;
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) set_point_.shift[axis] = axes_[axis].shift();
}

void HomingSource::cut_short(Ticks tick) noexcept {
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    if ((active_ & bit(axis)) != 0) report_end(axis, HomingEnd::kFault, tick);
  }
  over_ = true;
}

void HomingSource::report_end(std::size_t index, HomingEnd how, Ticks tick) noexcept {
  const AxisHoming& axis = axes_[index];
  events_.on_event(HomingEnded{.tag = request_.tag,
                               .axis = static_cast<std::uint8_t>(index + 1),
                               .how = how,
                               .met = axis.reached_switch(),
                               .tick = tick,
                               .taken = tick - begun_[index],
                               .edge_to_index = axis.edge_to_index(),
                               .shift = how == HomingEnd::kHomed ? axis.shift() : Counts{}});
}

}  // namespace armature
