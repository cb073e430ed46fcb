// The source of set-points that homes axes (axis_homing.hpp), while the arm has no other motion.
//
// The axes with the lowest HomingModel::order begin together, then those with the next one. When all stand, the source
// reports the counts by which the position of each homed axis must be shifted, and the motion loop does it. If an axis
// fails, the others of its order stop and no further one begins; axes that were homed before stay so.
//
// The limit switches of the axes are the source's: they cause no fault.
#pragma once

#include <cstdint>

#include "controller/activity/activity_source.hpp"
#include "controller/activity/homing/axis_homing.hpp"
#include "controller/activity/homing/homing_request.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/message/event.hpp"
#include "controller/motion/logic_port.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class HomingSource final : public ActivitySource {
 public:
  // References must outlive the source.
  HomingSource(const RobotModel& robot, LogicPort& logic, EventListener& events) noexcept;
  HomingSource(const HomingSource&) = delete;
  HomingSource& operator=(const HomingSource&) = delete;

  // ActivitySource; the content of a request is a HomingRequest for axes that have a HomingModel. The last set-point
  // reports the shift. A stop brakes all axes with the full acceleration.
  void begin(const Request& first, const PerAxis<Radians>& stand, Ticks tick) noexcept override;
  void feed(const Request&) noexcept override {}
  void stop(StopKind how) noexcept override;
  SetPoint& advance(Ticks tick, const RunControl::View& control) noexcept override;
  [[nodiscard]] bool over() noexcept override { return over_; }
  void reset_to(const PerAxis<Radians>& position) noexcept override { set_point_ = {.position = position}; }
  void cut_short(Ticks tick) noexcept override;

 private:
  void begin_next_order(Ticks tick) noexcept;
  void advance_axis(std::size_t axis, Ticks tick) noexcept;
  [[nodiscard]] HomingSensors sensors(std::size_t axis) noexcept;
  void report_end(std::size_t axis, HomingEnd how, Ticks tick) noexcept;
  void brake() noexcept;
  void finish() noexcept;

  const RobotModel& robot_;
  LogicPort& logic_;
  EventListener& events_;
  PerAxis<AxisHoming> axes_;
  PerAxis<Ticks> begun_{};
  HomingRequest request_{};
  std::uint8_t waiting_ = 0;  // mask of axes that have not begun
  std::uint8_t active_ = 0;   // mask of axes that are not over
  std::uint8_t homed_ = 0;    // mask
  bool stopped_ = false;      // by a stop
  bool over_ = true;
};

}  // namespace armature
