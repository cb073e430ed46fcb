// The modes of feed, units, plane, distances and path control, and the end of the program.
#include "controller/language/gcode/executor.hpp"

namespace armature::gcode {

Executor::Failure Executor::set_feed(const Block& block) noexcept {
  if (const CodeInfo* code = block.code(Group::kFeedMode)) {
    modes_.inverse_time = code->tenths == 930;
    modes_.feed = 0.0;
    emit(SetFeedMode{modes_.inverse_time});
    if (!modes_.inverse_time) emit(SetFeedRate{});
  }
  if (!block.words.has('f')) return std::nullopt;
  const double feed = block.words.get('f');
  if (feed < 0.0) return error_of(ErrorCode::kWordNegative, 'f');
  modes_.feed = feed;
  if (!modes_.inverse_time) emit(SetFeedRate{.mm_min = feed * unit_mm(), .number = feed});
  return std::nullopt;
}

void Executor::set_units_and_plane(const Block& block) noexcept {
  if (const CodeInfo* code = block.code(Group::kPlane)) {
    modes_.plane = code->tenths == 170 ? Plane::kXy : code->tenths == 180 ? Plane::kXz : Plane::kYz;
    emit(SelectPlane{modes_.plane});
  }
  if (const CodeInfo* code = block.code(Group::kUnits)) {
    modes_.inches = code->tenths == 200;
    emit(UseLengthUnits{modes_.inches});
  }
}

Executor::Failure Executor::set_control(const Block& block) noexcept {
  if (const CodeInfo* code = block.code(Group::kControl)) {
    using Mode = SetMotionControlMode::Mode;
    modes_.control = {};
    if (code->tenths == 640) {
      for (const char letter : {'p', 'q'}) {
        if (block.words.get(letter) < 0.0) return error_of(ErrorCode::kWordNegative, letter);
      }
      modes_.control.tolerance_mm = block.words.get('p') * unit_mm();
      modes_.naive_cam_mm = block.words.has('q') ? block.words.get('q') * unit_mm() : modes_.control.tolerance_mm;
    } else {
      modes_.control.mode = code->tenths == 610 ? Mode::kExactPath : Mode::kExactStop;
    }
    emit_control();
  }
  if (const CodeInfo* code = block.code(Group::kDistance)) modes_.incremental = code->tenths == 910;
  if (const CodeInfo* code = block.code(Group::kArcDistance)) modes_.absolute_centres = code->tenths == 901;
  if (const CodeInfo* code = block.code(Group::kRetract)) modes_.retract_to_start = code->tenths == 980;
  return std::nullopt;
}

void Executor::emit_control() noexcept {
  emit(modes_.control);
  if (modes_.control.mode == SetMotionControlMode::Mode::kContinuous) emit(SetNaiveCamTolerance{modes_.naive_cam_mm});
}

void Executor::end_program(bool shuttle) noexcept {
  parameters_.at(kSystemParameter) = 1.0;
  apply_offsets(with_system(1));
  emit(SetG5xOffset{.index = 1, .offset = offsets_.g5x});
  emit(SetXyRotation{offsets_.rotation_deg});
  if (modes_.plane != Plane::kXy) emit(SelectPlane{});
  emit(SetFeedMode{});
  emit(SetFeedRate{});
  if (!modes_.overrides[static_cast<std::size_t>(EnableOverride::Kind::kFeed)]) emit(EnableOverride{});
  emit(StopSpindle{});
  emit(SetSpindleMode{});
  if (modes_.mist) emit(Mist{});
  if (modes_.flood) emit(Flood{});
  if (shuttle) emit(PalletShuttle{});
  emit(ProgramEnd{});
  const Modes before = modes_;
  modes_ = Modes{};
  modes_.motion = find_code('g', 10);
  modes_.inches = before.inches;
  modes_.selected_tool = before.selected_tool;
  modes_.tool = before.tool;
  modes_.overrides = before.overrides;
  modes_.overrides[static_cast<std::size_t>(EnableOverride::Kind::kFeed)] = true;
}

}  // namespace armature::gcode
