// What a pulse-input servo drive, its motor and its gear do in one step, as numbers of all axes at once.
//
// All of them are at the joint: the motor's angle and speed divided by the gear ratio, its torque times the ratio, its
// inertia times the square. Units are rad, s, N m. `step` is the integration step.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "cosim/logic/axis_pairs.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

struct ServoNumbers {
  double step_s = 0.0;
  AxisNumbers rad_per_count;  // negative where motor and joint turn in opposite directions

  // ---- command
  AxisNumbers lag_kept;           // of the smoothing filter, the part of its lag that is left after a step
  AxisNumbers position_gain;      // [1/s]
  AxisNumbers feed_forward;       // speed for a step of the filtered command [1/s]
  AxisNumbers unseen;             // half an encoder count: the position loop sees no smaller error
  AxisNumbers max_speed;          // of the command
  AxisNumbers torque_per_speed;   // speed loop [N m s]
  AxisNumbers integral_per_step;  // step / integral time
  AxisNumbers max_torque;
  AxisNumbers current_per_step;  // part of a torque step that the current loop makes in a step

  // ---- motor
  AxisNumbers speed_per_torque;                           // step / inertia of the motor
  AxisNumbers driven_drag;                                // factor of the speed in a step: viscous friction
  AxisNumbers shorted_drag;                               // the same with shorted windings: the dynamic brake
  AxisNumbers friction;                                   // speed that Coulomb friction takes in a step
  AxisNumbers holding;                                    // speed that the engaged brake takes in a step
  PerAxis<std::int32_t> engage_steps{}, release_steps{};  // delay of the brake

  // ---- gear and bearing of the joint
  AxisNumbers half_play;
  AxisNumbers stiffness;  // [N m/rad]
  AxisNumbers damping;    // [N m s/rad]
  AxisNumbers bearing;    // viscous friction of the joint [N m s/rad]

  // ---- overload alarm: the heat of a drive is 0 when cold, and trips at 1
  AxisNumbers heating;  // in a step with a torque of 1 N m; it grows with the square. 0: there is no alarm
  AxisNumbers cooling;  // in a step
};

// Throws std::invalid_argument when a number is not positive that must be, or a loop is too fast for the step.
[[nodiscard]] ServoNumbers servo_numbers(const PerAxis<AxisSpec>& axes, double step_s);

}  // namespace armature::cosim
