// One drive and its motor, stepped by hand.
#pragma once

#include <cstddef>

#include "cosim/plant/clock.hpp"
#include "cosim/plant/independent_axes.hpp"
#include "cosim/plant/servo_drive.hpp"

namespace armature::cosim::test {

class DrivenMotor {
 public:
  explicit DrivenMotor(const AxisSpec& spec = {}) : drive{0, spec}, mechanics_{robot_of(spec)} {}

  void on_pins(Cycles now, bool step, bool dir, bool servo_on) {
    Shaft shaft = shafts_[0];
    drive.on_pins(now, step, dir, servo_on, shaft);
    shafts_.set(0, shaft);
  }

  // One step of the plant.
  void step() {
    MotorDemands demands;
    demands.set(0, drive.demand());
    mechanics_.step(0b1, demands, shafts_);
    drive.observe(shafts_[0]);
  }

  [[nodiscard]] Subcounts position() const { return drive.position(shafts_[0]); }
  [[nodiscard]] double following_error() const { return drive.following_error(shafts_[0]); }  // [counts]
  [[nodiscard]] double speed() const { return shafts_[0].speed / kPlantStepSeconds; }         // [counts/s]

  ServoDrive drive;

 private:
  static RobotSpec robot_of(const AxisSpec& spec) {
    RobotSpec robot;
    robot.axes[0] = spec;
    return robot;
  }

  IndependentAxes mechanics_;
  Shafts shafts_;
};

}  // namespace armature::cosim::test
