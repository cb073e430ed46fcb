#include "controller/activity/stream/stream_path.hpp"

#include "controller/base/timebase.hpp"

namespace armature {

void StreamPath::begin(const StreamSample& first) noexcept {
  first_ = 0;
  count_ = 1;
  complete_ = slopes_fixed_ = false;
  knots_[0] = {.time = first.time, .joint_rad = first.joint_rad};
}

bool StreamPath::add(const StreamSample& sample) noexcept {
  if (count_ == kMax || sample.time <= newest()) return false;
  at(count_++) = {.time = sample.time, .joint_rad = sample.joint_rad};
  complete_ = sample.kind == StreamSample::Kind::kLast;
  return true;
}

void StreamPath::move_to(Ticks time) noexcept {
  while (count_ > 1 && time >= at(1).time) {
    // The slope at the end of a cubic is that at the start of the next one.
    first_ = (first_ + 1) % kMax;
    --count_;
    slopes_fixed_ = false;
  }
  if (slopes_fixed_ || count_ < 2 || time < at(0).time) return;
  set_slope(1);
  slopes_fixed_ = true;
}

// From the neighbours of knot i, which is not the oldest one.
void StreamPath::set_slope(std::size_t i) noexcept {
  if (complete_ && i + 1 == count_) {
    at(i).slope_rad_s = {};
    return;
  }
  const Knot& before = at(i - 1);
  const Knot& after = i + 1 < count_ ? at(i + 1) : at(i);
  const double time_s = seconds(after.time - before.time);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    at(i).slope_rad_s[axis] = (after.joint_rad[axis] - before.joint_rad[axis]) / time_s;
  }
}

AxisState StreamPath::state(std::size_t axis, Ticks time) const noexcept {
  const Knot& from = at(0);
  if (count_ < 2 || time < from.time) return {.position = from.joint_rad[axis]};
  const Knot& to = at(1);
  const double length_s = seconds(to.time - from.time), t_s = seconds(time - from.time);
  const double way = to.joint_rad[axis] - from.joint_rad[axis];
  const double v0 = from.slope_rad_s[axis], v1 = to.slope_rad_s[axis];
  const double mean = way / length_s;
  const double c2 = (3.0 * mean - 2.0 * v0 - v1) / length_s;
  const double c3 = (v0 + v1 - 2.0 * mean) / (length_s * length_s);
  return {.position = from.joint_rad[axis] + t_s * (v0 + t_s * (c2 + t_s * c3)),
          .velocity = v0 + t_s * (2.0 * c2 + t_s * 3.0 * c3),
          .accel = 2.0 * c2 + 6.0 * c3 * t_s};
}

}  // namespace armature
