// The modal state that M70 and M73 save, and M72 and the return from a call restore.
#include <algorithm>

#include "controller/language/gcode/executor.hpp"

namespace armature::gcode {

Executor::Failure Executor::use_saved_state(const Block& block) noexcept {
  const CodeInfo* code = block.code(Group::kState);
  if (code == nullptr) return std::nullopt;
  SavedState& saved = saved_[call_level_];
  if (code->tenths == 720) {
    if (!saved.valid) return error_of(ErrorCode::kNoSavedState, *code);
    restore_state(saved);
  } else if (code->tenths == 710) {
    saved.valid = false;
  } else {
    saved = {.valid = true,
             .at_return = code->tenths == 730,
             .system = static_cast<int>(parameters_.at(kSystemParameter)),
             .has_tool_offset = has_tool_offset(),
             .modes = modes_};
  }
  return std::nullopt;
}

void Executor::begin_call() noexcept {
  ++call_level_;
  saved_[call_level_].valid = false;
}

void Executor::end_call() noexcept {
  const SavedState& saved = saved_[call_level_];
  if (saved.valid && saved.at_return) restore_state(saved);
  --call_level_;
}

// In the order of rs274. Adaptive feed stays as it is, and so does the motion mode.
void Executor::restore_state(const SavedState& saved) noexcept {
  const Modes& to = saved.modes;
  if (modes_.inches != to.inches) {
    modes_.inches = to.inches;
    emit(UseLengthUnits{modes_.inches});
  }
  if (modes_.inverse_time != to.inverse_time) {
    modes_.inverse_time = to.inverse_time;
    modes_.feed = 0.0;
    emit(SetFeedMode{modes_.inverse_time});
    if (!modes_.inverse_time) emit(SetFeedRate{});
  }
  if (modes_.feed != to.feed) {
    modes_.feed = to.feed;
    if (!modes_.inverse_time) emit(SetFeedRate{.mm_min = modes_.feed * unit_mm(), .number = modes_.feed});
  }
  if (modes_.surface_most_rpm != to.surface_most_rpm) emit(SetSpindleMode{to.surface_most_rpm});
  modes_.surface_most_rpm = to.surface_most_rpm;
  if (modes_.speed_rpm != to.speed_rpm) emit(SetSpindleSpeed{to.speed_rpm});
  modes_.speed_rpm = to.speed_rpm;
  if (modes_.spindle != to.spindle) turn_spindle(to.spindle);
  if (modes_.plane != to.plane) emit(SelectPlane{to.plane});
  modes_.plane = to.plane;
  if (!saved.has_tool_offset && has_tool_offset()) {
    Offsets changed = offsets_;
    changed.tool = {};
    apply_offsets(changed);
    emit(UseToolLengthOffset{offsets_.tool});
  }
  change_system(saved.system);
  if (modes_.control.mode != to.control.mode || modes_.control.tolerance_mm != to.control.tolerance_mm ||
      modes_.naive_cam_mm != to.naive_cam_mm) {
    modes_.control = to.control;
    modes_.naive_cam_mm = to.naive_cam_mm;
    emit_control();
  }
  modes_.incremental = to.incremental;
  modes_.absolute_centres = to.absolute_centres;
  modes_.retract_to_start = to.retract_to_start;
  restore_coolant(to.mist, to.flood);
  using Kind = EnableOverride::Kind;
  for (const Kind kind : {Kind::kFeed, Kind::kSpeed, Kind::kFeedHold}) {
    const auto index = static_cast<std::size_t>(kind);
    if (modes_.overrides[index] != to.overrides[index]) switch_override(kind, to.overrides[index]);
  }
}

void Executor::restore_coolant(bool mist, bool flood) noexcept {
  if (!mist && !flood && (modes_.mist || modes_.flood)) {
    modes_.mist = modes_.flood = false;
    emit(Mist{});
    emit(Flood{});
    return;
  }
  if (mist && !modes_.mist) emit(Mist{true});
  if (flood && !modes_.flood) emit(Flood{true});
  modes_.mist = modes_.mist || mist;
  modes_.flood = modes_.flood || flood;
}

bool Executor::has_tool_offset() const noexcept {
  return std::ranges::any_of(offsets_.tool, [](double value) { return value != 0.0; });
}

}  // namespace armature::gcode
