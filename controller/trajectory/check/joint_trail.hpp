// The joints at some times of a plan, from which its set-points can be followed again without those before.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "controller/kinematics/ik_result.hpp"

namespace armature {

class JointTrail {
 public:
  struct Place {
    double ticks = 0.0;
    JointAngles joints{};
  };

  void begin(const JointAngles& start) noexcept {
    size_ = 1;
    every_ = 8.0;
    places_[0] = {0.0, start};
  }
  // In order of time. Those of ticks are left out where another one is close; a sample of the path is farther away, and
  // the joints move little up to it.
  void add_tick(double ticks, const JointAngles& joints) noexcept {
    if (ticks >= places_[size_ - 1].ticks + every_) add_sample(ticks, joints);
  }
  void add_sample(double ticks, const JointAngles& joints) noexcept {
    if (!(ticks > places_[size_ - 1].ticks)) return;
    if (size_ == kMax) thin_out();
    places_[size_++] = {ticks, joints};
  }
  // The last place at or before a time >= 0.
  [[nodiscard]] const Place& before(double ticks) const noexcept {
    const auto first = places_.begin(), end = first + static_cast<std::ptrdiff_t>(size_);
    const auto behind = std::upper_bound(first + 1, end, ticks, [](double t, const Place& p) { return t < p.ticks; });
    return *(behind - 1);
  }

 private:
  static constexpr std::size_t kMax = 1024;

  // Leaves every second place.
  void thin_out() noexcept {
    for (std::size_t i = 0; 2 * i < size_; ++i) places_[i] = places_[2 * i];
    size_ = (size_ + 1) / 2;
    every_ *= 2.0;
  }

  std::array<Place, kMax> places_{};
  std::size_t size_ = 0;
  double every_ = 8.0;
};

}  // namespace armature
