// The motions of a block: lines, arcs, cycles and the ways home.
#pragma once

#include "controller/language/gcode/canon/arc.hpp"
#include "controller/language/gcode/canon/line_calls.hpp"
#include "controller/language/gcode/execute/coordinates.hpp"
#include "controller/language/gcode/execute/cycles.hpp"
#include "controller/language/gcode/execute/modes.hpp"
#include "controller/language/gcode/reader/block.hpp"

namespace armature::gcode {

class Motion {
 public:
  Motion(LineCalls& calls, const Modes& modes, Coordinates& coordinates, Cycles& cycles) noexcept
      : calls_(calls), modes_(modes), coordinates_(coordinates), cycles_(cycles) {}

  // The motion mode; null: G80.
  [[nodiscard]] const CodeInfo* active() const noexcept { return active_; }

  void begin_program() noexcept { active_ = nullptr; }
  void end_program() noexcept { active_ = find_code('g', 10); }

  // Replaces the words @ and ^ by X and Y. They count from the place before the line, in its modes.
  [[nodiscard]] Failure set_polar(Block& block) const noexcept;
  [[nodiscard]] Failure move(const Block& block) noexcept;
  // G28 and G30, by the first parameter of their place.
  void go_home(const Block& block, int parameter) noexcept;

 private:
  [[nodiscard]] Failure move_straight(const Block& block) noexcept;
  [[nodiscard]] Failure move_arc(const Block& block) noexcept;
  // The centre of an arc, from the radius or from the words of the centre.
  [[nodiscard]] Failure find_centre(const Block& block, PlanePoint from, PlanePoint to,
                                    PlanePoint& centre) const noexcept;
  // The feed of a motion with this length or, if it has none, this angle. Makes the call for it with inverse time.
  [[nodiscard]] Failure apply_feed(const Block& block, double length_mm, double angle_deg) noexcept;
  void traverse(const Axes6& end) noexcept;

  LineCalls& calls_;
  const Modes& modes_;
  Coordinates& coordinates_;
  Cycles& cycles_;
  const CodeInfo* active_ = nullptr;
};

}  // namespace armature::gcode
