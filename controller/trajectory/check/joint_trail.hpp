// The joints at some ticks of a plan, from which its set-points can be followed again without the ticks before.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/kinematics/ik_result.hpp"

namespace armature {

class JointTrail {
 public:
  struct Place {
    std::int64_t tick = 0;
    JointAngles joints{};
  };

  void begin(const JointAngles& start) noexcept {
    size_ = 1;
    every_ = 8;
    places_[0] = {0, start};
  }
  // Call at every tick from 1 on. The places are up to (tick / 128) ticks apart.
  void add(std::int64_t tick, const JointAngles& joints) noexcept {
    if (tick % every_ != 0) return;
    if (size_ == kMax) thin_out();
    if (tick % every_ == 0) places_[size_++] = {tick, joints};
  }
  // The last place at or before `tick` >= 0.
  [[nodiscard]] const Place& before(std::int64_t tick) const noexcept {
    const auto index = static_cast<std::size_t>(tick / every_);
    return places_[index < size_ ? index : size_ - 1];
  }

 private:
  static constexpr std::size_t kMax = 256;

  // Leaves every second place.
  void thin_out() noexcept {
    for (std::size_t i = 0; 2 * i < size_; ++i) places_[i] = places_[2 * i];
    size_ = (size_ + 1) / 2;
    every_ *= 2;
  }

  std::array<Place, kMax> places_{};
  std::size_t size_ = 0;
  std::int64_t every_ = 8;
};

}  // namespace armature
