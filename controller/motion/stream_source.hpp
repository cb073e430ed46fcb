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

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/message/stream_ended.hpp"
#include "controller/motion/motion_source.hpp"
#include "controller/motion/stream_path.hpp"
#include "controller/motion/stream_sample.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/state/axis_follower.hpp"

namespace armature {

class StreamSource final : public MotionSource {
 public:
  // The robot must outlive the source.
  explicit StreamSource(const RobotModel& robot) noexcept : robot_{robot} {}
  StreamSource(const StreamSource&) = delete;
  StreamSource& operator=(const StreamSource&) = delete;

  // Starts a stream with its first set-point, for an arm that stands at `position`.
  void begin(const StreamSample& first, const PerAxis<Radians>& position, Ticks tick) noexcept;
  // A later set-point, or a stop.
  void accept(const StreamSample& sample) noexcept;
  // The arm stands, and its last pulse is emitted.
  [[nodiscard]] bool over() const noexcept { return still_ticks_ >= kTicksToEmit; }
  [[nodiscard]] const StreamEnded& result() const noexcept { return result_; }

  // MotionSource
  const SetPoint& advance(Ticks tick) noexcept override;
  void reset_to(const PerAxis<Radians>& position) noexcept override { set_point_.position = position; }
  void cut_short(Ticks tick) noexcept override;
  void cancel(Ticks) noexcept override {}
  [[nodiscard]] Stopping stopping() const noexcept override;

 private:
  void follow(Ticks time) noexcept;
  void brake(StreamEnded::How how) noexcept;
  void brake_hard() noexcept;

  const RobotModel& robot_;
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
