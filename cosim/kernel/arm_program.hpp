// The program of a scenario, loaded for the controller: what the controller has in its memory on the robot.
#pragma once

#include <memory>

#include "controller/kinematics/arm.hpp"
#include "controller/language/program/program.hpp"
#include "controller/robot/robot_model.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

class ArmProgram {
 public:
  // The scenario has a program, which its loader has checked. It must outlive this.
  explicit ArmProgram(const Scenario& scenario);
  ~ArmProgram();
  ArmProgram(const ArmProgram&) = delete;
  ArmProgram& operator=(const ArmProgram&) = delete;

  // It lives as long as this, and so must whatever executes it.
  [[nodiscard]] Program& interpreter() { return *interpreter_; }

 private:
  struct Gcode;
  struct Jobs;

  void load_gcode(const Scenario& scenario);
  void load_jobs(const Scenario& scenario);

  RobotModel robot_;
  Arm arm_;
  std::unique_ptr<Gcode> gcode_;
  std::unique_ptr<Jobs> jobs_;
  Program* interpreter_ = nullptr;
};

}  // namespace armature::cosim
