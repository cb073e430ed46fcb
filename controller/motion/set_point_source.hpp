// The source of set-points: the only interface of the motion loop to motion.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/message/telemetry.hpp"

namespace armature {

// Outputs to be written: those of `mask`, bit i for pin i + 1.
struct PinLevels {
  std::uint16_t mask = 0;
  std::uint16_t levels = 0;
};

// The output of a source for one tick.
struct SetPoint {
  PerAxis<Radians> position{};             // of the next tick; 0 for axes that the robot does not have
  double rate = 0.0;                       // as in Telemetry
  MotionState state = MotionState::kIdle;  // never kFault
  bool stopped = false;                    // a stop is complete or had no effect; core 1 waits for this
  bool wake = false;                       // something happened in this tick that core 1 waits for
  bool planned = false;                    // a motion from a state of motion was planned in this tick, or a part of it
  std::int64_t inverses = 0;               // inverse kinematics computed in this tick
  PinLevels pins{};                        // outputs to be written at the start of the next tick
  // Masks of axes, bit 0 for axis 1. `homing`: their joint angles are not known, and the source obeys their limit
  // switches. `located`: they stand, and their encoder positions must be shifted now; then reset_to() follows.
  std::uint8_t homing = 0;
  std::uint8_t located = 0;
  PerAxis<Counts> shift{};  // of located axes
};

// A set of pulses is committed in one tick, starts with the next trigger, and is complete at the one after.
inline constexpr int kTicksToEmit = 2;

class SetPointSource {
 public:
  // Computes the set-point of the next tick. Call once per tick, outside Fault.
  virtual const SetPoint& advance(Ticks tick) noexcept = 0;
  // The set-point of the last tick, or the position of reset_to().
  [[nodiscard]] const SetPoint& last() const noexcept { return *last_; }

  // Cancels the present motion and stands at `position`, ready to start there.
  virtual void reset_to(const PerAxis<Radians>& position) noexcept = 0;
  // A fault begins in this tick: motions that have started end here and are reported as cut short.
  virtual void cut_short(Ticks tick) noexcept = 0;
  // Cancels the present motion and all waiting ones. Called in each tick of a Fault.
  virtual void cancel(Ticks tick) noexcept = 0;

  // An order of core 1 for the loop, once.
  enum class Order : std::uint8_t { kNone, kSwitchOff, kClearFault };
  [[nodiscard]] virtual Order take_order() noexcept { return Order::kNone; }

 protected:
  SetPointSource() = default;
  SetPointSource(const SetPointSource&) = delete;
  SetPointSource& operator=(const SetPointSource&) = delete;
  ~SetPointSource() = default;  // never owned through this interface

  SetPoint set_point_{};
  const SetPoint* last_ = &set_point_;  // a source of sources uses the set-point of one of them
};

}  // namespace armature
