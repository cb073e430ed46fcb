// Solves one pose and shows all joint angles on the serial line, as the program of Hu 2012 (Figure 2) does on its
// console. The paper runs it on a Nios II; this ARM core takes its place.
//
//   solutions 8 status 0 selected 1
//   branch 0 shoulder 1 elbow 1 flip 1 singular 0 clamped 0 angle1=-13.929790531 angle2=0.761595562 ...
//   ...
//   end
//
// Angles are those of the joints in degrees, with 9 decimals. Every line ends with CR and LF. `status` is IkStatus as a
// number, the other words are those of IkSolutions and IkBranch.
#pragma once

#include <cstddef>
#include <string_view>

#include "controller/drivers/axi_uart16550.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/host_memory/inverse_task.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/language/text/fixed_text.hpp"

namespace armature {

class InverseConsole {
 public:
  // Longer than any line.
  using Line = FixedText<256>;

  // Line 1 of the text, and the line of a branch of an arm with this number of axes.
  [[nodiscard]] static Line first_line(const IkSolutions& solutions) noexcept;
  [[nodiscard]] static Line branch_line(const IkSolutions& solutions, std::size_t branch, std::size_t axes) noexcept;

  // References must outlive the console. It has the serial line for itself.
  InverseConsole(const Arm& arm, std::size_t axes, const InverseTask& task, RegisterBus& bus) noexcept
      : arm_{arm}, axes_{axes}, task_{task}, bus_{bus}, uart_{bus} {}

  // Returns when the last bytes are in the FIFO of the UART, or when wait_for_interrupt() returns kNone. The inverse
  // kinematics is between an access of the UART and the charge for kInverse, so a simulation can measure it.
  void run() noexcept;

 private:
  [[nodiscard]] bool send(std::string_view text) noexcept;

  const Arm& arm_;
  std::size_t axes_;
  const InverseTask& task_;
  RegisterBus& bus_;
  AxiUart16550 uart_;
};

}  // namespace armature
