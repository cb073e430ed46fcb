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
    return pulses.count == 0 ? enabled() || idle() : enabled() && to_drop_ == 0 && to_double_ == 0;
  }
  [[nodiscard]] const StepInput& input() const { return input_; }
  [[nodiscard]] const ElectronicGear& gear() const { return state_.gear; }
  [[nodiscard]] double alarm_error() const { return alarm_error_; }  // [counts]
  [[nodiscard]] bool enabled() const { return servo_on_ && !state_.alarm; }
  // The drive has counted `count` more pulses, signed by their direction, and its shaft was observed; `moves`: further
  // steps are needed.
  void skip(std::int64_t count, bool in_position, bool moves);
  // What a tick changes.
  struct State {
    ElectronicGear gear;
    Pulses counted{};
    bool alarm = false;
    bool in_position = false;
    bool stepping_needed = false;
  };
  [[nodiscard]] const State& state() const { return state_; }
  void set_state(const State& state) { state_ = state; }
  void resume_input(bool step, bool dir, Cycles changed, Cycles turned) { input_.resume(step, dir, changed, turned); }

  // Fault script: the drive does not see the next `count` pulses (added to those still to be lost).
  void drop_pulses(std::int64_t count) { to_drop_ += count; }
  [[nodiscard]] std::int64_t pulses_to_drop() const { return to_drop_; }  // still to be lost

  // Fault script: the drive counts the next `count` pulses twice.
  void double_pulses(std::int64_t count) { to_double_ += count; }
  // Fault script: an internal fault, until as many calls of repair(). The alarm stays until the servo is off and the
  // fault is over.
  void trip();
  void repair();

  // demand() returns what the motor must do in the next step. observe() accepts the shaft after that step.
  // `overloaded`: the motor is too hot, which is an alarm.
  [[nodiscard]] MotorDemand demand() const;
  void observe(const Shaft& shaft, bool overloaded = false);

  // True when further steps change nothing as long as the inputs do not change.
  [[nodiscard]] bool idle() const { return !state_.stepping_needed; }

  // Position of the motor.
  [[nodiscard]] Subcounts position(const Shaft& shaft) const { return position_at(state_.gear, shaft.error); }
  // That of a shaft with this error from the reference of the gear.
  [[nodiscard]] static Subcounts position_at(const ElectronicGear& gear, double error) {
    const double offset = gear.fraction() + error;
    const std::int64_t subcounts = floor_of(offset * static_cast<double>(kSubcountsPerCount) + 0.5);
    return Subcounts{gear.whole() * kSubcountsPerCount + subcounts};
  }
  // Reference minus position, 0 while not under control [counts].
  [[nodiscard]] double following_error(const Shaft& shaft) const { return enabled() ? -shaft.error : 0.0; }

  // ---- outputs, as of the last step
  [[nodiscard]] bool alarm() const { return state_.alarm; }
  [[nodiscard]] bool in_position() const { return state_.in_position; }
  static constexpr double kInPositionCounts = 5.0;  // in position below it

  // ---- every pulse on the pins is in exactly one of these, signed by its direction
  [[nodiscard]] Pulses counted_pulses() const { return state_.counted; }  // moved the reference
  // Lost by the fault script, less those that it has doubled.
  [[nodiscard]] Pulses dropped_pulses() const { return dropped_; }
  [[nodiscard]] Pulses ignored_pulses() const { return ignored_; }  // came while the servo was off or in alarm

  [[nodiscard]] const std::optional<InputViolation>& violation() const { return input_.violation(); }

 private:
  void handle_pulse(int direction, Shaft& shaft);
  void switch_on(Shaft& shaft);

  StepInput input_;
  State state_;
  double alarm_error_;
  bool servo_on_ = false;
  std::int64_t to_drop_ = 0;
  std::int64_t to_double_ = 0;
  int trips_ = 0;  // internal faults
  Pulses dropped_{};
  Pulses ignored_{};
};

}  // namespace armature::cosim
