// The load side of all gears: the arm as rigid bodies that the gears turn.
//
//   M(q) qdd = torques of the gears - bias(q, qd)
//
// M, its inverse and the bias are renewed once in a tick of 50 us, not in each step of 5 us. A joint at 2 rad/s turns
// by 1e-4 rad in a tick, so they change by about that part of themselves. In a move at full speed, the positions of the
// motors differ by 0.025 counts from those with a renewal in each step, 2e-5 of the lag (tests/cosim/servo).
#pragma once

#include "controller/base/axes.hpp"
#include "cosim/dynamics/arm_dynamics.hpp"
#include "cosim/logic/axis_pairs.hpp"

namespace armature::cosim {

class LoadSide {
 public:
  // What a posture determines.
  struct State {
    PerAxis<AxisNumbers> inverse{};  // of M: column i for a torque at joint i [1/(kg m^2)]
    AxisNumbers bias;                // [N m]
  };

  explicit LoadSide(const ArmModel& model) : arm_{model} {}

  // For joint angles in rad and speeds in rad/s.
  [[nodiscard]] State at(const AxisNumbers& angles, const AxisNumbers& speeds);
  // Torques that hold the arm in this posture [N m].
  [[nodiscard]] PerAxis<double> gravity(const PerAxis<double>& angles);

 private:
  ArmDynamics arm_;
};

}  // namespace armature::cosim
