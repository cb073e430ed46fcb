// One axis of the robot: servo drive, motor and encoder.
#pragma once

#include <cstddef>
#include <cstdint>

#include "controller/core/units.hpp"
#include "cosim/plant/incremental_encoder.hpp"
#include "cosim/plant/servo_drive.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

class Axis {
 public:
  Axis(std::size_t axis, const AxisSpec& spec);

  // Integrates the step that begins at `now`; the encoder's edges of that step are known from then on. The reference
  // of the step is what the drive has counted up to now, so a pulse acts on the motor at the next step.
  void step(Cycles now);

  [[nodiscard]] ServoDrive& drive() { return drive_; }
  [[nodiscard]] const ServoDrive& drive() const { return drive_; }
  [[nodiscard]] IncrementalEncoder& encoder() { return encoder_; }
  [[nodiscard]] const IncrementalEncoder& encoder() const { return encoder_; }

  // True motor position at `now` as a joint angle [deg].
  [[nodiscard]] double joint_deg(Cycles now) const;

 private:
  ServoDrive drive_;
  IncrementalEncoder encoder_;
  double joint_deg_per_count_;
};

}  // namespace armature::cosim
