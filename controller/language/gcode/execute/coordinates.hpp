// The place of the tool in the coordinates of the program: coordinate systems, offsets, tool offset, stored places.
#pragma once

#include <optional>
#include <string_view>

#include "controller/language/gcode/canon/line_calls.hpp"
#include "controller/language/gcode/canon/offsets.hpp"
#include "controller/language/gcode/execute/modes.hpp"
#include "controller/language/gcode/execute/tools.hpp"
#include "controller/language/gcode/reader/block.hpp"
#include "controller/language/gcode/reader/parameters.hpp"

namespace armature::gcode {

class Coordinates {
 public:
  // The offsets of the systems and the stored places are parameters.
  Coordinates(LineCalls& calls, const Modes& modes, Tools& tools, Parameters& parameters) noexcept
      : calls_(calls), modes_(modes), tools_(tools), parameters_(parameters) {}

  // Where the tool is, in the active coordinate system and in that of the machine.
  [[nodiscard]] const Axes6& place() const noexcept { return place_; }
  [[nodiscard]] Axes6 machine() const noexcept { return offsets_.machine(place_); }
  void move_to(const Axes6& place) noexcept { place_ = place; }
  [[nodiscard]] std::optional<double> value_of(std::string_view name) const noexcept;
  [[nodiscard]] std::optional<double> value_of(int parameter) const noexcept;

  void begin_program(const Axes6& machine) noexcept;
  void end_program() noexcept;

  // Where a motion ends, with absolute or incremental distances.
  [[nodiscard]] Axes6 target(const Words& words) const noexcept;
  // The same with coordinates of the machine: G53.
  [[nodiscard]] Axes6 machine_target(const Words& words) const noexcept;

  // G43, G43.1 and G49.
  [[nodiscard]] Failure set_tool_offset(const Block& block) noexcept;
  [[nodiscard]] bool has_tool_offset() const noexcept;
  void use_tool_offset(const Axes6& offset) noexcept;
  // G54 to G59.3, the systems 1 to 9. A program may have set the parameter to anything else, which counts as 1.
  void set_system(const Block& block) noexcept;
  [[nodiscard]] int system() const noexcept;
  void change_system(int system) noexcept;
  // G10.
  [[nodiscard]] Failure set_data(const Block& block) noexcept;
  // G52 and G92 to G92.3.
  void set_g92(const Block& block) noexcept;
  // The places of G28 and G30, by their first parameter.
  void store_home(int parameter) noexcept { store(parameter, machine()); }
  [[nodiscard]] Axes6 home(int parameter) const noexcept { return offsets_.place(stored(parameter)); }

 private:
  [[nodiscard]] Failure set_tool_data(const Block& block, int kind) noexcept;
  [[nodiscard]] Failure set_system_data(const Block& block, int kind) noexcept;
  // The axis words in place of some of the coordinates.
  [[nodiscard]] Axes6 with_words(const Words& words, Axes6 axes) const noexcept;
  // The tool stays where it is.
  void apply(const Offsets& offsets) noexcept;
  [[nodiscard]] Offsets with_system(int system) const noexcept;
  [[nodiscard]] Axes6 stored(int parameter) const noexcept;
  void store(int parameter, const Axes6& axes) noexcept;

  LineCalls& calls_;
  const Modes& modes_;
  Tools& tools_;
  Parameters& parameters_;
  Offsets offsets_{};
  Axes6 place_{};
};

}  // namespace armature::gcode
