// A servo drive: pulse input, electronic gear, servo enable and alarm. It turns pulses into the reference of its motor,
// which Mechanics moves, and checks the position of the motor.
//
// Servo off (`servo_on` low) or alarm: pulses are ignored, a dynamic brake stops the motor. When the servo is switched
// on the reference starts at the encoder count where the motor is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/units.hpp"
#include "cosim/plant/electronic_gear.hpp"
#include "cosim/plant/mechanics.hpp"
#include "cosim/plant/step_input.hpp"
#include "cosim/plant/subcounts.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

class ServoDrive {
 public:
  // The motor stands at the encoder count `start`.
  ServoDrive(std::size_t axis, const AxisSpec& spec, Counts start = {});

  // Levels of the drive's inputs after clock edge `now`; to be called when one of them has changed. A pulse moves the
  // reference, from which the error of the shaft is measured.
  void on_pins(Cycles now, bool step, bool dir, bool servo_on, Shaft& shaft);

  // ---- whole ticks: pulses without their edges
  // Whether each pulse moves the reference, or none comes.
  [[nodiscard]] bool takes(const AxisPulses& pulses) const {
    return pulses.count == 0 ? enabled() || idle() : enabled() && to_drop_ == 0;
  }
  [[nodiscard]] const StepInput& input() const { return input_; }
  // The next `count` pulses, signed by their direction.
  void take(std::int32_t count, Shaft& shaft);
  void resume_input(bool step, bool dir, Cycles changed, Cycles turned) { input_.resume(step, dir, changed, turned); }

  // Fault script: the drive does not see the next `count` pulses (added to those still to be lost).
  void drop_pulses(std::int64_t count) { to_drop_ += count; }
  [[nodiscard]] std::int64_t pulses_to_drop() const { return to_drop_; }  // still to be lost

  // demand() returns what the motor must do in the next step. observe() accepts the shaft after that step.
  [[nodiscard]] MotorDemand demand() const;
  void observe(const Shaft& shaft);

  // True when further steps change nothing as long as the inputs do not change.
  [[nodiscard]] bool idle() const { return !stepping_needed_; }

  // Position of the motor.
  [[nodiscard]] Subcounts position(const Shaft& shaft) const;
  // Reference minus position, 0 while not under control [counts].
  [[nodiscard]] double following_error(const Shaft& shaft) const { return enabled() ? -shaft.error : 0.0; }

  // ---- outputs, as of the last step
  [[nodiscard]] bool alarm() const { return alarm_; }
  [[nodiscard]] bool in_position() const { return in_position_; }

  // ---- every pulse on the pins is in exactly one of these, signed by its direction
  [[nodiscard]] Pulses counted_pulses() const { return counted_; }  // moved the reference
  [[nodiscard]] Pulses dropped_pulses() const { return dropped_; }  // lost by the fault script
  [[nodiscard]] Pulses ignored_pulses() const { return ignored_; }  // came while the servo was off or in alarm

  [[nodiscard]] const std::optional<InputViolation>& violation() const { return input_.violation(); }

 private:
  [[nodiscard]] bool enabled() const { return servo_on_ && !alarm_; }
  void handle_pulse(int direction, Shaft& shaft);
  void switch_on(Shaft& shaft);

  StepInput input_;
  ElectronicGear gear_;
  double alarm_error_;  // [counts]
  bool servo_on_ = false;
  bool alarm_ = false;
  bool in_position_ = false;
  bool stepping_needed_ = false;
  std::int64_t to_drop_ = 0;
  Pulses counted_{};
  Pulses dropped_{};
  Pulses ignored_{};
};

}  // namespace armature::cosim
