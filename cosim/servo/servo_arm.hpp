// Six pulse-input servo drives with their motors, gears and brakes, and the arm that they move.
//
// Drive: smoothing filter of the command, position loop P with speed feed-forward, speed loop PI whose integral stands
// while the torque is limited, current loop of first order, limits of speed and torque. The gains follow from the
// natural frequency wn and the damping zeta of the robot file: position gain wn / (2 zeta), speed loop 2 zeta wn for
// the inertia that the file names. Without integral and filter, and with a rigid gear, the axis then is the system of
// second order of plant = "servo". The lag behind a ramp is 2 zeta / wn x speed.
// Motor: inertia, viscous and Coulomb friction, a dynamic brake (shorted windings, a viscous torque) while the servo is
// off, a holding brake with delays, which slips above its torque. Friction is an impulse: in a step it takes at most
// friction x step from the momentum, and never turns the speed. So the motor really stops, and stays.
// Overload alarm: see ServoNumbers. A drive that is hot does not rest: it cools down.
// Gear: backlash, then a spring with a damper. The load side follows from the rigid bodies of the arm.
//
// Step: speeds first, then positions with the new speeds (semi-implicit Euler). It keeps the energy of an oscillation
// for wn h < 2; the constructor refuses gears with more than 0.5. With h = 5 us a gear of 20 000 N m/rad before 0.002
// kg m^2 has 0.016: its frequency is off by (wn h)^2 / 24 = 1e-5. Lags are off by h / 2. No substeps are needed.
// Cost: see cosim/servo/README.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "cosim/dynamics/arm_dynamics.hpp"
#include "cosim/logic/axis_bits.hpp"
#include "cosim/logic/axis_pairs.hpp"
#include "cosim/servo/load_side.hpp"
#include "cosim/servo/servo_numbers.hpp"

namespace armature::cosim {

class ServoArm {
 public:
  // The posture of the load side is renewed in every `renewal`th step. Throws std::invalid_argument when a gear is too
  // stiff for the step.
  ServoArm(const ServoNumbers& numbers, const ArmModel& model, int renewal);

  // One step. `controlled`: drives that control their motors, one bit each; the others short the windings. The motor's
  // position is reference + error, in counts; the step changes the errors and sets the speeds [counts/step]. The speed
  // is not 0 as long as a part of the axis may still move. Before the first step the arm rests, held by its brakes.
  void step(std::uint8_t controlled, const AxisNumbers& reference, AxisNumbers& error, AxisNumbers& speed);

  // The shaft of this motor cannot turn while `on` (fault script).
  void block(std::size_t axis, bool on) { set_bit(blocked_, axis, on); }

  // The brake of this motor has this share of its torque, 0..1 (fault script).
  void weaken_brake(std::size_t axis, double share) {
    brake_share_[axis] = share;
    if (state_.braking[axis] != 0.0) state_.braking[axis] = numbers_.holding[axis] * share;
  }

  // This torque acts on the joint, behind its gear [N m] (fault script).
  void push(std::size_t axis, double torque_nm) { pushed_[axis] = torque_nm; }

  // keep() marks this moment; take_back() returns to it.
  void keep() { kept_ = state_; }
  void take_back() { state_ = kept_; }

  // Motor minus load, as joint angles [rad].
  [[nodiscard]] double twist_rad(std::size_t axis) const { return state_.twist[axis]; }
  [[nodiscard]] double load_speed(std::size_t axis) const { return state_.load_speed[axis]; }  // [rad/s]
  [[nodiscard]] double motor_torque(std::size_t axis) const { return state_.torque[axis]; }    // [N m] at the joint
  // Drives whose overload alarm has tripped since they control their motors, one bit each.
  [[nodiscard]] std::uint8_t overloaded() const { return state_.overloaded; }
  [[nodiscard]] bool brake_engaged(std::size_t axis) const { return state_.braking[axis] != 0.0; }

 private:
  struct State {
    bool begun = false;
    int until_renewal = 0;
    std::uint8_t controlled = 0;       // in the latest step
    PerAxis<std::int32_t> brake_in{};  // steps until the brake changes; 0: it does not
    AxisNumbers braking;               // speed that it takes in a step, 0 while released
    AxisNumbers reference;             // in the latest step [counts]
    AxisNumbers lag;                   // of the smoothing filter [rad]
    AxisNumbers integral;              // of the speed error [rad/s]
    AxisNumbers torque;                // of the motor [N m]
    AxisNumbers speed, load_speed;     // [rad/s]
    AxisNumbers twist;                 // [rad]
    AxisNumbers heat;                  // of the drives, 1 is the overload
    std::uint8_t overloaded = 0;
    LoadSide::State load;
  };

  void begin(const AxisNumbers& reference, const AxisNumbers& error);
  void renew(const AxisNumbers& reference, const AxisNumbers& error);
  void switch_drives(std::uint8_t controlled, const AxisNumbers& reference);
  void wait_for_brakes();
  [[nodiscard]] WholePair controlled_lanes(std::size_t pair) const;
  void control(std::size_t pair, WholePair controlled, Pair reference, Pair error);
  [[nodiscard]] Pair gear_torque(std::size_t pair) const;
  void turn_motor(std::size_t pair, WholePair controlled, Pair load);
  bool turn_loads(const std::array<Pair, kAxisPairs>& gears);
  void warm_drives(std::uint8_t controlled);
  [[nodiscard]] WholePair rest_lanes(std::size_t pair, bool loads_move) const;

  ServoNumbers numbers_;
  LoadSide arm_;
  int renewal_;
  std::uint8_t blocked_ = 0;  // one bit per axis
  AxisNumbers pushed_;        // [N m]
  PerAxis<double> brake_share_{1, 1, 1, 1, 1, 1};
  State state_, kept_;
};

}  // namespace armature::cosim
