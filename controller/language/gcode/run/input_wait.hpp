// The wait of a program for an input of the tool: M66.
#pragma once

#include <optional>

#include "controller/base/units.hpp"
#include "controller/language/gcode/canon/canon.hpp"
#include "controller/language/program/program_port.hpp"

namespace armature::gcode {

class InputWait {
 public:
  [[nodiscard]] bool active() const noexcept { return active_; }
  // `place`: of the line that waits.
  void begin(const WaitInput& wait, ProgramPlace place, Ticks now) noexcept;
  void cancel() noexcept { active_ = false; }
  // The value for the program when the wait is over; nothing as long as it waits. Notes both.
  [[nodiscard]] std::optional<double> step(ProgramPort& port) noexcept;

 private:
  bool active_ = false;
  bool first_ = false;  // the level was not read yet
  bool last_level_ = false;
  WaitInput wait_{};
  ProgramPlace place_ = 0;
  Ticks start_{};
};

}  // namespace armature::gcode
