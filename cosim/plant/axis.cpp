#include "cosim/plant/axis.hpp"

#include "cosim/plant/clock.hpp"

namespace armature::cosim {

Axis::Axis(std::size_t axis, const AxisSpec& spec)
    : drive_{axis, spec},
      encoder_{4 * spec.encoder_lines},
      joint_deg_per_count_{360.0 / (spec.gear_ratio * 4.0 * static_cast<double>(spec.encoder_lines))} {}

void Axis::step(Cycles now) {
  drive_.step();
  encoder_.move(now, kPlantStep, drive_.position());
}

double Axis::joint_deg(Cycles now) const {
  return encoder_.position(now) * joint_deg_per_count_;
}

}  // namespace armature::cosim
