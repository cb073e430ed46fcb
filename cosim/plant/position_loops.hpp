// The position loops of all axes (position_loop.hpp), two axes at a time: a step within their limits. The same
// operations as PositionLoop::step(), so the same bits.
#pragma once

#include <cstddef>

#include "controller/base/axes.hpp"
#include "cosim/logic/axis_pairs.hpp"
#include "cosim/plant/position_loop.hpp"

namespace armature::cosim {

class PositionLoops {
 public:
  void set(std::size_t axis, const PositionLoop::Numbers& numbers) {
    error_by_error_[axis] = numbers.error_by_error;
    error_by_speed_[axis] = numbers.error_by_speed;
    speed_by_error_[axis] = numbers.speed_by_error;
    speed_by_speed_[axis] = numbers.speed_by_speed;
    max_accel_[axis] = numbers.max_accel;
    max_speed_[axis] = numbers.max_speed;
    rest_speed_[axis] = numbers.rest_speed;
  }

  // What has happened in steps.
  struct Events {
    WholePair within{~0, ~0};  // no limit has acted; otherwise a step was not that of PositionLoop
    WholePair rested{};        // the shaft was set to rest
  };
  // A step of the shafts of the pair `i`.
  void step(std::size_t i, Pair& error, Pair& speed, Events& events) const {
    const Pair error_before = error, speed_before = speed;
    error = error_by_error_.pair(i) * error_before + error_by_speed_.pair(i) * speed_before;
    speed = speed_by_error_.pair(i) * error_before + speed_by_speed_.pair(i) * speed_before;
    events.within &= magnitude(speed - speed_before) <= max_accel_.pair(i);
    events.within &= magnitude(speed) <= max_speed_.pair(i);
    const WholePair rests =
        (magnitude(error) < both(PositionLoop::kRestCounts)) & (magnitude(speed) < rest_speed_.pair(i));
    events.rested |= rests;
    error = only(~rests, error);
    speed = only(~rests, speed);
  }

 private:
  AxisNumbers error_by_error_, error_by_speed_, speed_by_error_, speed_by_speed_;
  AxisNumbers max_accel_, max_speed_, rest_speed_;
};

}  // namespace armature::cosim
