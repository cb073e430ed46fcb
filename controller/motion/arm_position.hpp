// Where the arm is, for core 1. Core 0 writes it in each tick; each value is one of the last two ticks.
#pragma once

#include <atomic>
#include <cstddef>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"

namespace armature {

class ArmPosition {
 public:
  // Core 0.
  void set(std::size_t axis, Radians reference, Radians actual) noexcept {
    reference_[axis].store(reference.value(), std::memory_order_relaxed);
    actual_[axis].store(actual.value(), std::memory_order_relaxed);
  }

  // The set-points. At rest they are where the next plan starts.
  [[nodiscard]] PerAxis<Radians> reference() const noexcept { return read(reference_); }
  // As the encoders have it.
  [[nodiscard]] PerAxis<Radians> actual() const noexcept { return read(actual_); }

 private:
  using Values = PerAxis<std::atomic<double>>;
  static_assert(std::atomic<double>::is_always_lock_free);

  [[nodiscard]] static PerAxis<Radians> read(const Values& values) noexcept {
    return make_per_axis([&](std::size_t axis) { return Radians{values[axis].load(std::memory_order_relaxed)}; });
  }

  Values reference_{}, actual_{};
};

}  // namespace armature
