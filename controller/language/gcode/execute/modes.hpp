// The modes of feed, units, plane, distances and path control.
#pragma once

#include <optional>
#include <string_view>

#include "controller/language/gcode/canon/line_calls.hpp"
#include "controller/language/gcode/reader/block.hpp"

namespace armature::gcode {

class Modes {
 public:
  struct Values {
    Plane plane = Plane::kXy;
    bool inches = false;
    bool incremental = false;
    bool absolute_centres = false;
    bool inverse_time = false;
    bool retract_to_start = true;  // G98
    SetMotionControlMode control{};
    double naive_cam_mm = 0.0;
    double feed = 0.0;  // as programmed
  };

  explicit Modes(LineCalls& calls) noexcept : calls_(calls) {}

  [[nodiscard]] const Values& active() const noexcept { return active_; }
  [[nodiscard]] double unit_mm() const noexcept { return active_.inches ? kMmPerInch : 1.0; }
  [[nodiscard]] std::optional<double> value_of(std::string_view name) const noexcept;

  void begin_program() noexcept;
  // The units stay.
  void end_program() noexcept;

  [[nodiscard]] Failure set_feed(const Block& block) noexcept;
  void set_units_and_plane(const Block& block) noexcept;
  [[nodiscard]] Failure set_control(const Block& block) noexcept;
  void set_distances(const Block& block) noexcept;

  // These make the calls of what changes.
  void restore_units_and_feed(const Values& to) noexcept;
  void restore_plane(const Values& to) noexcept;
  void restore_control_and_distances(const Values& to) noexcept;

 private:
  void set_units(bool inches) noexcept;
  void set_plane(Plane plane) noexcept;
  void set_feed_mode(bool inverse_time) noexcept;
  void set_feed_rate(double feed) noexcept;
  void emit_control() noexcept;

  LineCalls& calls_;
  Values active_{};
};

}  // namespace armature::gcode
