// The tools of a program. The planner knows one, that of the arm; the poses of another one are converted to it.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/kinematics/transform.hpp"
#include "controller/language/job/state/alarm.hpp"
#include "controller/language/job/state/machine_setup.hpp"

namespace armature::job {

class Tools {
 public:
  // The reference must outlive it.
  explicit Tools(const MachineSetup& setup) noexcept : setup_{setup} {}

  void reset() noexcept {
    present_.reset();
    arm_tool_.reset();
  }
  // The arm carries one tool, by any number, and those that the settings state. kTool: a second one that they do not.
  [[nodiscard]] Alarm use(std::uint8_t tool) noexcept;
  // The number of the tool in use; 0 before the first one.
  [[nodiscard]] std::uint8_t present() const noexcept { return present_.value_or(0); }
  // From the tool of the arm to another one.
  [[nodiscard]] Transform arm_T_tool(std::uint8_t tool) const noexcept;

 private:
  [[nodiscard]] const Transform* stated(std::uint8_t tool) const noexcept;  // null: the settings state none

  const MachineSetup& setup_;
  std::optional<std::uint8_t> present_{};
  std::optional<std::uint8_t> arm_tool_{};  // the number by which the program names the tool of the arm
};

}  // namespace armature::job
