// The branches of a pose as the firmware on a Cortex-A9 shows them on its serial line, and what they have cost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "controller/base/units.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/transform.hpp"
#include "cosim/cli/kinematics/solution_difference.hpp"
#include "cosim/cli/options/kinematics_io.hpp"

namespace armature::cosim {

struct ConsoleSolutions {
  IkSolutions solutions;          // as the text has them; limits and turns are judged by the host
  std::string console;            // the text, with a line feed behind each line
  std::int64_t instructions = 0;  // of the inverse kinematics
  Cycles clocks{};                // of 20 ns, for them
  SolutionDifference difference;  // from those of the host

  void add_to(nlohmann::ordered_json& json) const;
  [[nodiscard]] std::string text() const;  // lines below the table of solutions
};

// Throws InputError in a program that executes no ARM instructions, and std::runtime_error when the text is not, byte
// for byte, that of the controller that is compiled for the host.
[[nodiscard]] ConsoleSolutions solve_on_a9(const ArmOfFile& robot, const Transform& base_T_flange,
                                           const JointAngles& previous);

// The branches of a text of the console (controller/app/inverse_console.hpp), without the carriage returns. All that
// it does not have is that of `host`. Throws std::runtime_error when it is another one.
[[nodiscard]] IkSolutions parse_console(std::string_view text, const IkSolutions& host, std::size_t axes);

}  // namespace armature::cosim
