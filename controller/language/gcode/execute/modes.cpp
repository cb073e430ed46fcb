#include "controller/language/gcode/execute/modes.hpp"

namespace armature::gcode {

std::optional<double> Modes::value_of(std::string_view name) const noexcept {
  constexpr int kPlaneCode = 170;
  return find_value(name, {{"_plane", static_cast<double>(kPlaneCode + 10 * static_cast<int>(active_.plane))},
                           {"_metric", flag(!active_.inches)},
                           {"_imperial", flag(active_.inches)},
                           {"_absolute", flag(!active_.incremental)},
                           {"_incremental", flag(active_.incremental)},
                           {"_inverse_time", flag(active_.inverse_time)},
                           {"_units_per_minute", flag(!active_.inverse_time)},
                           {"_feed", active_.feed},
                           {"_ijk_absolute_mode", flag(active_.absolute_centres)},
                           {"_retract_old_z", flag(active_.retract_to_start)},
                           {"_retract_r_plane", flag(!active_.retract_to_start)}});
}

void Modes::begin_program() noexcept {
  active_ = {};
  calls_.emit(UseLengthUnits{});
}

void Modes::end_program() noexcept {
  if (active_.plane != Plane::kXy) calls_.emit(SelectPlane{});
  calls_.emit(SetFeedMode{});
  calls_.emit(SetFeedRate{});
  active_ = {.inches = active_.inches};
}

Failure Modes::set_feed(const Block& block) noexcept {
  if (const CodeInfo* code = block.code(Group::kFeedMode)) set_feed_mode(code->tenths == 930);
  if (!block.words.has('f')) return std::nullopt;
  const double feed = block.words.get('f');
  if (feed < 0.0) return error_of(ErrorCode::kWordNegative, 'f');
  set_feed_rate(feed);
  return std::nullopt;
}

void Modes::set_units_and_plane(const Block& block) noexcept {
  if (const CodeInfo* code = block.code(Group::kPlane)) {
    set_plane(code->tenths == 170 ? Plane::kXy : code->tenths == 180 ? Plane::kXz : Plane::kYz);
  }
  if (const CodeInfo* code = block.code(Group::kUnits)) set_units(code->tenths == 200);
}

Failure Modes::set_control(const Block& block) noexcept {
  using Mode = SetMotionControlMode::Mode;
  const CodeInfo* code = block.code(Group::kControl);
  if (code == nullptr) return std::nullopt;
  if (code->tenths == 640) {
    for (const char letter : {'p', 'q'}) {
      if (block.words.get(letter) < 0.0) return error_of(ErrorCode::kWordNegative, letter);
    }
    active_.control = {.tolerance_mm = block.words.get('p') * unit_mm()};
    active_.naive_cam_mm = block.words.has('q') ? block.words.get('q') * unit_mm() : active_.control.tolerance_mm;
  } else {
    active_.control = {.mode = code->tenths == 610 ? Mode::kExactPath : Mode::kExactStop};
  }
  emit_control();
  return std::nullopt;
}

void Modes::set_distances(const Block& block) noexcept {
  if (const CodeInfo* code = block.code(Group::kDistance)) active_.incremental = code->tenths == 910;
  if (const CodeInfo* code = block.code(Group::kArcDistance)) active_.absolute_centres = code->tenths == 901;
  if (const CodeInfo* code = block.code(Group::kRetract)) active_.retract_to_start = code->tenths == 980;
}

void Modes::restore_units_and_feed(const Values& to) noexcept {
  if (active_.inches != to.inches) set_units(to.inches);
  if (active_.inverse_time != to.inverse_time) set_feed_mode(to.inverse_time);
  if (active_.feed != to.feed) set_feed_rate(to.feed);
}

void Modes::restore_plane(const Values& to) noexcept {
  if (active_.plane != to.plane) set_plane(to.plane);
}

void Modes::restore_control_and_distances(const Values& to) noexcept {
  if (active_.control.mode != to.control.mode || active_.control.tolerance_mm != to.control.tolerance_mm ||
      active_.naive_cam_mm != to.naive_cam_mm) {
    active_.control = to.control;
    active_.naive_cam_mm = to.naive_cam_mm;
    emit_control();
  }
  active_.incremental = to.incremental;
  active_.absolute_centres = to.absolute_centres;
  active_.retract_to_start = to.retract_to_start;
}

void Modes::set_units(bool inches) noexcept {
  active_.inches = inches;
  calls_.emit(UseLengthUnits{inches});
}

void Modes::set_plane(Plane plane) noexcept {
  active_.plane = plane;
  calls_.emit(SelectPlane{plane});
}

void Modes::set_feed_mode(bool inverse_time) noexcept {
  active_.inverse_time = inverse_time;
  calls_.emit(SetFeedMode{inverse_time});
  set_feed_rate(0.0);
}

// With inverse time, each motion makes the call for itself.
void Modes::set_feed_rate(double feed) noexcept {
  active_.feed = feed;
  if (!active_.inverse_time) calls_.emit(SetFeedRate{.mm_min = feed * unit_mm(), .number = feed});
}

void Modes::emit_control() noexcept {
  calls_.emit(active_.control);
  if (active_.control.mode == SetMotionControlMode::Mode::kContinuous) {
    calls_.emit(SetNaiveCamTolerance{active_.naive_cam_mm});
  }
}

}  // namespace armature::gcode
