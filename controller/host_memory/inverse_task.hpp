// A pose that core 1 solves instead of moving the robot (app/inverse_console.hpp).
#pragma once

#include <cstdint>
#include <string_view>

#include "controller/base/members.hpp"
#include "controller/base/misfit.hpp"
#include "controller/drivers/axi_uart16550.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/transform.hpp"

namespace armature {

struct InverseTask {
  static constexpr std::string_view kEnd = "end\r\n";  // the last line of the text

  Transform base_T_flange{};
  JointAngles previous{};       // the turns of the joints are the nearest to these
  std::int32_t baud = 115'200;  // of the serial line that shows the text; 8 data bits, no parity, one stop bit

  [[nodiscard]] const void* misfit() const noexcept {
    return first_misfit({{&baud, AxiUart16550::divisor(baud) != 0}});
  }
  ARMATURE_MEMBERS(InverseTask, base_T_flange, previous, baud)
};

}  // namespace armature
