// Instructions that use time and the pins of the tool. False: the step says why the record is not executed.
#pragma once

#include <cstddef>
#include <optional>

#include "controller/language/job/state/operand_reader.hpp"
#include "controller/language/job/state/pin_levels.hpp"
#include "controller/language/job/state/step.hpp"

namespace armature::job {

class Pins {
 public:
  void reset() noexcept {
    levels_.reset();
    finish_record();
  }
  // What is kept of a record that waits ends with it.
  void finish_record() noexcept {
    wait_start_.reset();
    group_bit_ = 0;
  }
  [[nodiscard]] const PinLevels& levels() const noexcept { return levels_; }

  // TIMER.
  [[nodiscard]] bool dwell(Step& step, OperandReader& operands) noexcept;
  // WAIT.
  [[nodiscard]] bool wait(Step& step, OperandReader& operands) noexcept;
  // DOUT: one output, or each output of a group in its order, until there is no room for more commands.
  [[nodiscard]] bool switch_outputs(Step& step, OperandReader& operands) noexcept;
  [[nodiscard]] bool switch_output(Step& step, std::size_t pin, bool level) noexcept;
  // DIN.
  [[nodiscard]] bool read_pins(Step& step, OperandReader& operands) noexcept;
  // PULSE: starts when the arm is there; the program continues at once.
  [[nodiscard]] bool pulse(Step& step, OperandReader& operands) noexcept;

 private:
  PinLevels levels_{};
  std::optional<Ticks> wait_start_{};
  std::size_t group_bit_ = 0;  // of DOUT of a group: the next one
};

}  // namespace armature::job
