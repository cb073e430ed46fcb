// Converts user input to the types and units of the controller.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/app/controller_config.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/language/gcode/run/motion_setup.hpp"
#include "controller/language/job/state/machine_setup.hpp"
#include "controller/message/command.hpp"
#include "controller/robot/robot_model.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

[[nodiscard]] RobotModel to_robot_model(const RobotSpec& robot);
[[nodiscard]] ControllerConfig to_controller_config(const Scenario& scenario);
[[nodiscard]] Transform to_transform(const PoseSpec& pose);
// For the program of a scenario. The references must outlive the setup.
[[nodiscard]] gcode::MotionSetup to_gcode_setup(const Scenario& scenario, const RobotModel& robot, const Arm& arm);
[[nodiscard]] job::MachineSetup to_job_setup(const Scenario& scenario, const RobotModel& robot, const Arm& arm);
[[nodiscard]] Command to_command(const CommandSpec& move);
// The set-point of that index.
[[nodiscard]] Command to_command(const StreamSpec& stream, std::size_t point);

}  // namespace armature::cosim
