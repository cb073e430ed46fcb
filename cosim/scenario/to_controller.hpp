// Converts user input to the types and units of the controller.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/host_memory/boot_memory.hpp"
#include "controller/host_memory/controller_config.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/language/gcode/run/motion_setup.hpp"
#include "controller/message/command.hpp"
#include "controller/robot/robot_model.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

[[nodiscard]] RobotModel to_robot_model(const RobotSpec& robot);
[[nodiscard]] ControllerConfig to_controller_config(const Scenario& scenario);
[[nodiscard]] Transform to_transform(const PoseSpec& pose);
// All that the controller starts with.
[[nodiscard]] host_memory::BootMemory to_boot_memory(const Scenario& scenario);
// For a check of the program of a scenario. The references must outlive the setup.
[[nodiscard]] gcode::MotionSetup to_gcode_setup(const Scenario& scenario, const RobotModel& robot, const Arm& arm);
[[nodiscard]] Command to_command(const CommandSpec& move);
// The set-point of that index.
[[nodiscard]] Command to_command(const StreamSpec& stream, std::size_t point);

}  // namespace armature::cosim
