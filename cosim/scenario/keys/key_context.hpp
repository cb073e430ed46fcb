// The context of a table: what its keys are checked against.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "cosim/cpu/cpu_spec.hpp"
#include "cosim/robot/robot_spec.hpp"
#include "cosim/scenario/keys/key_info.hpp"

namespace armature::cosim {

struct Scenario;

// The robot that the keys of a scenario are checked against.
struct ScenarioRobot {
  const RobotSpec* spec = nullptr;  // nullptr: it could not be read, and checks that need it are skipped
  std::string file;                 // for messages

  [[nodiscard]] bool lacks_kinematics() const { return spec != nullptr && !spec->kinematics; }
  // Elements that an array with one element an axis must have; 0: any number.
  [[nodiscard]] std::size_t axis_count() const { return spec == nullptr ? 0 : spec->axis_count; }
};

struct KeyContext {
  ScenarioRobot robot{};
  const Scenario* scenario = nullptr;  // the part that was read so far; nullptr for a robot file
  bool paper_keys = false;             // keys of the paper's variant are allowed
  std::optional<CpuKind> processor{};  // chosen in place of that of [cpu]

  [[nodiscard]] bool has(Needs needs) const;
  // The message when something is needed and missing; empty when it is there.
  [[nodiscard]] std::string lack_of(Needs needs) const;
};

}  // namespace armature::cosim
