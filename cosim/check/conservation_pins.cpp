// What the checker learns from the pins, and from ticks without edges.
#include "cosim/check/conservation.hpp"
#include "cosim/logic/axis_bits.hpp"

namespace armature::cosim {

void Conservation::on_outputs(Cycles now, const SocOutputs& out) {
  for_each_bit(out.step & ~step_, [&](std::size_t axis) {
    pins_[axis] += has_bit(out.dir, axis) == kDirForward ? 1 : -1;
    if (edges_[axis].first_rise == Cycles{}) edges_[axis].first_rise = now;
  });
  step_ = out.step;
  // Otherwise the pin stands still, and on_tick() knows the direction.
  if (!plant_.leaves_out_edges()) {
    for_each_bit(out.dir ^ dir_, [&](std::size_t axis) { edges_[axis].turned = now; });
    dir_ = out.dir;
  }
  servo_on_ = out.servo_on;
  servo_was_off_ |= static_cast<std::uint8_t>(~out.servo_on);
}

void Conservation::on_tick(const TickPulses& tick) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const AxisPulses& pulses = tick.axes[axis];
    if (pulses.count == 0) continue;
    pins_[axis] += pulses.count;
    edges_[axis].first_rise = pulses.first_rise();
    if (pulses.turned >= tick.begins) edges_[axis].turned = pulses.turned;
    set_bit(dir_, axis, (pulses.count > 0) == kDirForward);
  }
}

}  // namespace armature::cosim
