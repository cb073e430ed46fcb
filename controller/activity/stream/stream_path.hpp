// The set-points of a stream as a path over time: between two of them a cubic whose velocity at a set-point is the
// slope between its neighbours. So a smooth stream gives a smooth motion. Where the next neighbour is not known in
// time, it is the slope from the one before. The path begins and ends at rest.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/activity/stream/stream_sample.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/trajectory/state/phase_law.hpp"

namespace armature {

class StreamPath {
 public:
  // Set-points that may wait: as many as a client can be early.
  static constexpr std::size_t kMax = 32;

  void begin(const StreamSample& first) noexcept;
  // False when there is no room, or the time is not after the one before: it is dropped.
  bool add(const StreamSample& sample) noexcept;
  [[nodiscard]] Ticks newest() const noexcept { return at(count_ - 1).time; }

  // The state of an axis at a time that does not decrease from call to call, after move_to() it. Before the first and
  // after the newest set-point it stands there.
  [[nodiscard]] AxisState state(std::size_t axis, Ticks time) const noexcept;
  // Drops what is no longer needed for `time` and later ones.
  void move_to(Ticks time) noexcept;

 private:
  struct Knot {
    Ticks time{};
    PerAxis<double> joint_rad{};
    PerAxis<double> slope_rad_s{};
  };
  [[nodiscard]] const Knot& at(std::size_t i) const noexcept { return knots_[(first_ + i) % kMax]; }
  [[nodiscard]] Knot& at(std::size_t i) noexcept { return knots_[(first_ + i) % kMax]; }
  void set_slope(std::size_t i) noexcept;

  std::array<Knot, kMax> knots_{};
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  bool complete_ = false;      // the newest knot is the last one
  bool slopes_fixed_ = false;  // of the two knots of the present cubic: a later set-point does not change it
};

}  // namespace armature
