// The codes of drilling cycles: what a line and those before it say about its holes.
#pragma once

#include "controller/language/gcode/canon/line_calls.hpp"
#include "controller/language/gcode/execute/coordinates.hpp"
#include "controller/language/gcode/execute/drill_cycle.hpp"
#include "controller/language/gcode/execute/modes.hpp"
#include "controller/language/gcode/execute/overrides.hpp"
#include "controller/language/gcode/execute/spindle.hpp"
#include "controller/language/gcode/reader/block.hpp"

namespace armature::gcode {

class Cycles {
 public:
  Cycles(LineCalls& calls, const Modes& modes, const Spindle& spindle, const Overrides& overrides,
         Coordinates& coordinates) noexcept
      : modes_(modes), spindle_(spindle), overrides_(overrides), coordinates_(coordinates), drill_(calls) {}

  void begin_program() noexcept;

  // The cycle of a block. `active`: the motion mode of the block before; null: none.
  [[nodiscard]] Failure begin(const Block& block, const CodeInfo* active) noexcept;
  [[nodiscard]] bool active() const noexcept { return drill_.active(); }
  // Each call makes a few canonical calls.
  void step() noexcept;

 private:
  // What a line without these words takes from the line before, as long as the cycle continues.
  struct Memory {
    double start_height = 0.0;  // before the first of successive cycles
    double clearance = 0.0;     // these as programmed, in mm
    double bottom = 0.0;
    double peck = 0.0;
    double dwell_s = 0.0;
  };

  // Takes over what the line programs, and checks that it has what it must have. `continues`: the line before has the
  // same cycle.
  [[nodiscard]] Failure remember(const Block& block, bool continues) noexcept;
  [[nodiscard]] Failure remember_heights(const Block& block, bool continues) noexcept;
  [[nodiscard]] Failure remember_dwell(const Block& block, bool continues) noexcept;
  [[nodiscard]] Failure remember_peck(const Words& words, bool continues) noexcept;
  [[nodiscard]] DrillRequest holes_of(const Block& block, double clearance, double bottom) const noexcept;

  const Modes& modes_;
  const Spindle& spindle_;
  const Overrides& overrides_;
  Coordinates& coordinates_;
  DrillCycle drill_;
  Memory memory_{};
};

}  // namespace armature::gcode
