// Creates the processor that runs the controller. Only make_processor.cpp knows all implementations.
#pragma once

#include <memory>

#include "controller/app/controller_config.hpp"
#include "controller/robot/robot_model.hpp"
#include "cosim/cpu/cpu_spec.hpp"
#include "cosim/cpu/processor.hpp"

namespace armature::cosim {

// Both cores are at the start of their mains. A program in `config` must outlive the processor.
[[nodiscard]] std::unique_ptr<Processor> make_processor(const RobotModel& robot, const ControllerConfig& config,
                                                        const CpuSpec& spec);

}  // namespace armature::cosim
