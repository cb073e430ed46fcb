// The spindle, or a laser: its speed and its direction.
#pragma once

#include <optional>
#include <string_view>

#include "controller/language/gcode/canon/line_calls.hpp"
#include "controller/language/gcode/reader/block.hpp"

namespace armature::gcode {

class Spindle {
 public:
  struct Values {
    double speed_rpm = 0.0;
    double surface_max_rpm = 0.0;  // G96; 0: G97
    int direction = 0;             // 1 clockwise, -1 counterclockwise, 0 stands
  };

  explicit Spindle(LineCalls& calls) noexcept : calls_(calls) {}

  [[nodiscard]] const Values& active() const noexcept { return active_; }
  [[nodiscard]] std::optional<double> value_of(std::string_view name) const noexcept;

  void begin_program() noexcept { active_ = {}; }
  void end_program() noexcept;

  // G96, G97 and S.
  [[nodiscard]] Failure set_speed(const Block& block) noexcept;
  // M3, M4 and M5.
  void set_direction(const Block& block) noexcept;
  void turn(int direction) noexcept;
  // Makes the calls of what changes.
  void restore(const Values& to) noexcept;

 private:
  LineCalls& calls_;
  Values active_{};
};

}  // namespace armature::gcode
