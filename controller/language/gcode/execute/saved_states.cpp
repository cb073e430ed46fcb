#include "controller/language/gcode/execute/saved_states.hpp"

namespace armature::gcode {

void SavedStates::begin_program() noexcept {
  call_level_ = 0;
  saved_.front().reset();
}

void SavedStates::begin_call() noexcept {
  ++call_level_;
  saved_[call_level_].reset();
}

void SavedStates::end_call() noexcept {
  const std::optional<State>& saved = saved_[call_level_];
  if (saved && saved->at_return) restore(*saved);
  --call_level_;
}

Failure SavedStates::execute(const Block& block) noexcept {
  const CodeInfo* code = block.code(Group::kState);
  if (code == nullptr) return std::nullopt;
  std::optional<State>& saved = saved_[call_level_];
  if (code->tenths == 720) {
    if (!saved) return error_of(ErrorCode::kNoSavedState, *code);
    restore(*saved);
  } else if (code->tenths == 710) {
    saved.reset();
  } else {
    saved = State{.modes = modes_.active(),
                  .spindle = spindle_.active(),
                  .coolant = coolant_.active(),
                  .overrides = overrides_.active(),
                  .system = coordinates_.system(),
                  .has_tool_offset = coordinates_.has_tool_offset(),
                  .at_return = code->tenths == 730};
  }
  return std::nullopt;
}

// In the order of rs274. The motion mode stays as it is.
void SavedStates::restore(const State& state) noexcept {
  modes_.restore_units_and_feed(state.modes);
  spindle_.restore(state.spindle);
  modes_.restore_plane(state.modes);
  if (!state.has_tool_offset && coordinates_.has_tool_offset()) coordinates_.use_tool_offset({});
  coordinates_.change_system(state.system);
  modes_.restore_control_and_distances(state.modes);
  coolant_.restore(state.coolant);
  overrides_.restore(state.overrides);
}

}  // namespace armature::gcode
