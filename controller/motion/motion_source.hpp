// Where the set-points come from: all that the motion loop knows about motion. PlanRunner is one source; another one
// has a velocity or a stream of set-points.
#pragma once

#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/motion/telemetry.hpp"

namespace armature {

// What a source gives for one tick.
struct SetPoint {
  PerAxis<Radians> position{};             // of the next tick; those of axes that the robot has not stay 0
  double rate = 0.0;                       // as in Telemetry
  MotionState state = MotionState::kIdle;  // never kFault
  bool stopped = false;                    // a stop is complete, or was without effect: core 1 waits for this news
  bool wake = false;                       // core 1 waits for something that has happened in this tick
  std::int64_t inverses = 0;               // inverse kinematics computed in this tick
};

// How a source can stop, if a stop began now.
struct Stopping {
  bool possible = true;  // false: only a fault ends this motion
  // The stop ends within so many ticks of the motion as it is planned at full rate: a bound of the way, not of the
  // time.
  double within_ticks = 0.0;  // 0: at rest
};

class MotionSource {
 public:
  // Computes the set-point of the next tick. Once per tick, outside Fault.
  virtual const SetPoint& advance(Ticks tick) noexcept = 0;
  // That of the last tick, or where stand_at() has put it.
  [[nodiscard]] const SetPoint& last() const noexcept { return set_point_; }

  // Gives up what it does and stands at `position`, ready to start there.
  virtual void stand_at(const PerAxis<Radians>& position) noexcept = 0;
  // A fault begins in this tick: motions that have started end here and are reported as cut short.
  virtual void cut_short(Ticks tick) noexcept = 0;
  // Gives up what it does and everything that waits. In each tick of a Fault.
  virtual void give_up(Ticks tick) noexcept = 0;

  [[nodiscard]] virtual Stopping stopping() const noexcept = 0;
  [[nodiscard]] bool at_rest() const noexcept { return stopping().within_ticks == 0.0; }

 protected:
  MotionSource() = default;
  MotionSource(const MotionSource&) = default;
  MotionSource& operator=(const MotionSource&) = default;
  ~MotionSource() = default;  // never owned through this interface

  SetPoint set_point_{};
};

}  // namespace armature
