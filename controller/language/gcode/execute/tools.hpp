// The tool table, the tool that T has selected, and the tool in the spindle.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "controller/language/gcode/canon/line_calls.hpp"
#include "controller/language/gcode/canon/offsets.hpp"
#include "controller/language/gcode/execute/spindle.hpp"
#include "controller/language/gcode/reader/block.hpp"

namespace armature::gcode {

class Tools {
 public:
  using Table = std::array<std::optional<Axes6>, kMaxTools>;  // offsets by number; 0: no tool

  Tools(LineCalls& calls, Spindle& spindle) noexcept : calls_(calls), spindle_(spindle) {}

  // Adds a tool, 1..kMaxTools - 1. It stays for all programs.
  void add(int number, const Axes6& offset) noexcept { table_[static_cast<std::size_t>(number)] = offset; }
  // The same for several, without an offset.
  void add(const ToolNumbers& numbers) noexcept;
  [[nodiscard]] const Table& table() const noexcept { return table_; }
  void set_table(const Table& table) noexcept { table_ = table; }

  // The number of the tool in the spindle; 0: none.
  [[nodiscard]] int current() const noexcept { return current_; }
  // The offset of a tool, 0..kMaxTools - 1; null: the table does not have it.
  [[nodiscard]] Axes6* offset_of(int number) noexcept;
  [[nodiscard]] std::optional<double> value_of(std::string_view name) const noexcept;

  void begin_program() noexcept { selected_ = current_ = 0; }

  // T.
  [[nodiscard]] Failure select(const Block& block) noexcept;
  // M6. The spindle stops.
  void change(const Block& block) noexcept;

 private:
  LineCalls& calls_;
  Spindle& spindle_;
  Table table_{};
  int selected_ = 0;
  int current_ = 0;
};

}  // namespace armature::gcode
