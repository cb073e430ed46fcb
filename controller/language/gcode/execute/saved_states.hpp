// The modal states that M70 and M73 save, and M72 and the return from a call restore: one for each level of calls.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "controller/language/gcode/execute/coolant.hpp"
#include "controller/language/gcode/execute/coordinates.hpp"
#include "controller/language/gcode/execute/modes.hpp"
#include "controller/language/gcode/execute/overrides.hpp"
#include "controller/language/gcode/execute/spindle.hpp"
#include "controller/language/gcode/reader/block.hpp"
#include "controller/language/gcode/reader/parameters.hpp"

namespace armature::gcode {

class SavedStates {
 public:
  SavedStates(Modes& modes, Spindle& spindle, Coolant& coolant, Overrides& overrides, Coordinates& coordinates) noexcept
      : modes_(modes), spindle_(spindle), coolant_(coolant), overrides_(overrides), coordinates_(coordinates) {}

  // Calls that are under way.
  [[nodiscard]] std::size_t call_level() const noexcept { return call_level_; }

  void begin_program() noexcept;
  void begin_call() noexcept;
  void end_call() noexcept;
  // M70 to M73.
  [[nodiscard]] Failure execute(const Block& block) noexcept;

 private:
  struct State {
    Modes::Values modes{};
    Spindle::Values spindle{};
    Coolant::Values coolant{};
    Overrides::Values overrides{};
    int system = 1;
    bool has_tool_offset = false;
    bool at_return = false;  // M73
  };
  void restore(const State& state) noexcept;

  Modes& modes_;
  Spindle& spindle_;
  Coolant& coolant_;
  Overrides& overrides_;
  Coordinates& coordinates_;
  std::size_t call_level_ = 0;
  std::array<std::optional<State>, Parameters::kMaxCalls + 1> saved_{};  // by call level
};

}  // namespace armature::gcode
