// Follows a stream of joint set-points, as a servo controller with an outer client does (ros2_control, EtherCAT CSP, a
// learned policy).
//
// The arm follows the path through the set-points (stream_path.hpp) with a constant delay, which covers the interval of
// the set-points and their way from the client. Each axis is limited to what it may do (axis_follower.hpp): a stream
// within the limits is followed exactly, another one as close as the limits allow. At the end of its range an axis
// waits. The arm comes to rest at the last set-point. If the next set-point is not there when it is needed, and at a
// stop, each axis makes its fastest stop, and the stream is over.
#pragma once

#include <cstdint>

#include "controller/activity/activity_source.hpp"
#include "controller/activity/stream/stream_path.hpp"
#include "controller/activity/stream/stream_sample.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/message/event.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/state/axis_follower.hpp"

namespace armature {

class StreamSource final : public ActivitySource {
 public:
  // References must outlive the source.
  StreamSource(const RobotModel& robot, EventListener& events) noexcept : robot_{robot}, events_{events} {}
  StreamSource(const StreamSource&) = delete;
  StreamSource& operator=(const StreamSource&) = delete;

  // ActivitySource; the content of a request is a StreamSample.
  void begin(const Request& first, const PerAxis<Radians>& stand, Ticks tick) noexcept override;
  // A set-point that comes when the stream is complete has no effect.
  void feed(const Request& next) noexcept override;
  void stop(StopKind how) noexcept override;
  SetPoint& advance(Ticks tick, const RunControl::View& control) noexcept override;
  [[nodiscard]] bool over() noexcept override { return still_ticks_ >= kTicksToEmit; }
  void reset_to(const PerAxis<Radians>& position) noexcept override { set_point_.position = position; }
  void cut_short(Ticks tick) noexcept override;

 private:
  void follow(Ticks time) noexcept;
  void brake(StreamEnded::How how) noexcept;
  void brake_hard() noexcept;

  const RobotModel& robot_;
  EventListener& events_;
  StreamPath path_{};
  PerAxis<AxisFollower> axes_{};
  PerAxis<PhaseLaw> stops_{};  // while braking
  bool braking_ = false;
  std::int64_t braked_ticks_ = 0;
  bool complete_ = false;  // the last set-point has come
  Ticks start_{};          // the tick of time 0 of the stream
  int still_ticks_ = 0;
  StreamEnded result_{};
};

}  // namespace armature
