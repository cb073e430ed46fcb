#include "controller/activity/stream/stream_activity.hpp"

#include <utility>

#include "controller/activity/move_checks.hpp"
#include "controller/activity/stream/stream_sample.hpp"

namespace armature {

std::optional<MoveRefused> StreamActivity::accept(const StreamPoint& point) noexcept {
  const bool expected = expects(point);
  if (!point.first && !expected) return std::nullopt;  // the end of the stream was reported
  if (!context_.owner.referenced()) return refused(Refusal::kNotReferenced);
  if (!expected && !context_.owner.rest()) return refused(Refusal::kNotReady);
  return send(point);
}

std::optional<MoveRefused> StreamActivity::send(const StreamPoint& point) noexcept {
  if (point.first) {
    joints_ = context_.owner.end();
    time_ = Ticks{-1};
  }
  std::optional<MoveRefused> refusal = find_refusal(point);
  if (!refusal) refusal = solve(point);
  if (refusal) {
    if (active_) context_.owner.stop(StopKind::kSoft);
    closed_ = true;
    return refusal;
  }
  using Kind = StreamSample::Kind;
  StreamSample sample{.kind = point.first  ? Kind::kFirst
                              : point.last ? Kind::kLast
                                           : Kind::kNext,
                      .time = point.time,
                      .delay = point.delay,
                      .profile = point.profile,
                      .tag = point.tag};
  for (std::size_t axis = 0; axis < kAxes; ++axis) sample.joint_rad[axis] = joints_[axis].value();
  // No room only while core 0 does not run; the set-point is then missing, and the stream is late.
  if (point.first) {
    context_.owner.begin(ActivityId::kStream, sample);
  } else if (context_.channel.has_unread_at_most(Channel::kStream - 1)) {
    context_.owner.feed(ActivityId::kStream, sample);
  }
  time_ = point.time;
  tag_ = point.tag;
  active_ = true;
  closed_ = point.last;
  return std::nullopt;
}

std::optional<MoveRefused> StreamActivity::find_refusal(const StreamPoint& point) const noexcept {
  const MoveRefused invalid{.reason = Refusal::kInvalidTarget};
  if (point.time <= time_ || point.time > kLongestMove) return invalid;
  if (point.first) {
    if (point.time != Ticks{0} || point.delay <= Ticks{0} || point.delay > kLongestMove || point.last) return invalid;
    if (const std::optional<MoveRefused> refusal = find_profile_refusal(context_.robot, point.profile)) return refusal;
  }
  if (point.kind == StreamPoint::Kind::kTool) {
    if (context_.arm.known()) return std::nullopt;
    return refused(Refusal::kNoKinematics);
  }
  return armature::find_refusal(context_.robot,
                                make_per_axis([&](std::size_t axis) { return point.joints[axis].value(); }));
}

std::optional<MoveRefused> StreamActivity::solve(const StreamPoint& point) noexcept {
  if (point.kind == StreamPoint::Kind::kJoints) {
    joints_ = point.joints;
    return std::nullopt;
  }
  const Transform base_T_flange = Transform{point.rotation, point.position_mm} * inverse(context_.config.flange_T_tool);
  const IkTracking tracking = context_.arm.track(base_T_flange, joints_);
  ++inverses_;
  if (!solved(tracking.status)) return refusal_of(context_.robot, tracking);
  joints_ = tracking.joints;
  return std::nullopt;
}

std::int64_t StreamActivity::take_inverses() noexcept {
  return std::exchange(inverses_, 0);
}

}  // namespace armature
