// A pose that the controller solves on its core 1 (controller/app/inverse_console.hpp), in a chip of its own: the text
// that it sends, bit by bit, and what the inverse kinematics has cost.
#pragma once

#include <cstdint>
#include <string>

#include "controller/base/units.hpp"
#include "controller/host_memory/inverse_task.hpp"
#include "controller/robot/robot_model.hpp"
#include "cosim/cpu/cpu_spec.hpp"

namespace armature::cosim {

struct InverseRun {
  std::string text;               // of the serial line, without its last line
  std::int64_t instructions = 0;  // of the inverse kinematics; 0 of a processor that does not count them
  Cycles clocks{};                // of the logic, for these instructions
  Cycles end{};                   // when the last character was received
};

// The chip is the model of the logic, and core 0 sleeps. Throws InputError for a processor that is not provided, and
// std::runtime_error when the text is wrong or does not end within kLongestInverseRun.
[[nodiscard]] InverseRun run_inverse(const RobotModel& robot, const InverseTask& task, const CpuSpec& cpu);
inline constexpr Cycles kLongestInverseRun{100'000'000};  // 2 s: the longest text takes 0.15 s at 115200 baud

}  // namespace armature::cosim
