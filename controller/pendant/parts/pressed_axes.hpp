// The axes that the operator jogs. Each needs a repeated command as long as its key is pressed (dead-man).
#pragma once

#include <cstddef>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"
#include "controller/message/command.hpp"

namespace armature::pendant {

inline constexpr Ticks kDeadMan{2'000};  // 100 ms

class PressedAxes {
 public:
  // The key of an axis is pressed, with a share of the speed of jogs, -1 .. 1.
  void press(std::size_t axis, double share, Cycles now) noexcept {
    share_[axis] = share;
    pressed_[axis] = true;
    until_[axis] = now + Cycles{kDeadMan.value() * kTickCycles.value()};
  }
  void release() noexcept { pressed_ = {}; }

  [[nodiscard]] bool any(Cycles now) const noexcept {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (share(axis, now) != 0.0) return true;
    }
    return false;
  }
  // 0 when the key was released, or its command was not repeated.
  [[nodiscard]] double share(std::size_t axis, Cycles now) const noexcept {
    return pressed_[axis] && now < until_[axis] ? share_[axis] : 0.0;
  }

 private:
  PerAxis<double> share_{};
  PerAxis<Cycles> until_{};
  PerAxis<bool> pressed_{};
};

}  // namespace armature::pendant
