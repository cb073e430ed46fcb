#include "controller/language/gcode/execute/executor.hpp"

#include "controller/language/gcode/execute/outputs.hpp"

namespace armature::gcode {

void Executor::begin_program(const Axes6& machine) noexcept {
  after_ = After::kNext;
  returned_.reset();
  calls_.begin_line(0);
  parameters_.begin_program();
  modes_.begin_program();
  spindle_.begin_program();
  coolant_.begin_program();
  overrides_.begin_program();
  tools_.begin_program();
  coordinates_.begin_program(machine);
  saved_states_.begin_program();
  cycles_.begin_program();
  motion_.begin_program();
}

void Executor::end_program(bool shuttle) noexcept {
  coordinates_.end_program();
  modes_.end_program();
  overrides_.end_program();
  spindle_.end_program();
  coolant_.end_program();
  motion_.end_program();
  if (shuttle) calls_.emit(PalletShuttle{});
  calls_.emit(ProgramEnd{});
}

void Executor::save(Stored& stored) const noexcept {
  for (std::size_t i = 0; i < stored.parameters.size(); ++i) {
    stored.parameters[i] = parameters_.at(kFirstStored + static_cast<int>(i));
  }
  stored.tools = tools_.table();
}

void Executor::restore(const Stored& stored) noexcept {
  for (std::size_t i = 0; i < stored.parameters.size(); ++i) {
    parameters_.at(kFirstStored + static_cast<int>(i)) = stored.parameters[i];
  }
  tools_.set_table(stored.tools);
}

Failure Executor::execute(Block& block) noexcept {
  after_ = waits_for_input(block) ? After::kWaitInput : After::kNext;
  if (const Failure failure = motion_.set_polar(block)) return failure;
  if (const Failure failure = check_block(block, motion_.active())) return failure;
  if (const Failure failure = modes_.set_feed(block)) return failure;
  if (const Failure failure = spindle_.set_speed(block)) return failure;
  if (const Failure failure = tools_.select(block)) return failure;
  if (const Failure failure = set_outputs(block, calls_)) return failure;
  tools_.change(block);
  spindle_.set_direction(block);
  if (const Failure failure = saved_states_.execute(block)) return failure;
  coolant_.set(block);
  if (const Failure failure = overrides_.set(block)) return failure;
  if (const Failure failure = dwell(block)) return failure;
  modes_.set_units_and_plane(block);
  if (const Failure failure = coordinates_.set_tool_offset(block)) return failure;
  coordinates_.set_system(block);
  if (const Failure failure = modes_.set_control(block)) return failure;
  modes_.set_distances(block);
  if (const Failure failure = execute_once(block)) return failure;
  if (const Failure failure = motion_.move(block)) return failure;
  stop(block);
  return std::nullopt;
}

Failure Executor::dwell(const Block& block) noexcept {
  if (!block.is(Group::kOnce, 40)) return std::nullopt;
  if (!block.words.has('p')) return error_of(ErrorCode::kWordMissing, 'p');
  if (block.words.get('p') < 0.0) return error_of(ErrorCode::kWordNegative, 'p');
  calls_.emit(Dwell{block.words.get('p')});
  return std::nullopt;
}

// Without G4, which comes earlier, and G53, which is for a line.
Failure Executor::execute_once(const Block& block) noexcept {
  const CodeInfo* code = block.code(Group::kOnce);
  if (code == nullptr) return std::nullopt;
  switch (code->tenths) {
    case 100:
      return coordinates_.set_data(block);
    case 280:
      motion_.go_home(block, kHomeParameter);
      break;
    case 300:
      motion_.go_home(block, kSecondHomeParameter);
      break;
    case 281:
      coordinates_.store_home(kHomeParameter);
      break;
    case 301:
      coordinates_.store_home(kSecondHomeParameter);
      break;
    case 520:
    case 920:
    case 921:
    case 922:
    case 923:
      coordinates_.set_g92(block);
      break;
    default:
      break;
  }
  return std::nullopt;
}

// M2 and M30: the end; M0, M1 and M60: a pause.
void Executor::stop(const Block& block) noexcept {
  const CodeInfo* code = block.code(Group::kStop);
  if (code == nullptr) return;
  if (code->tenths == 20 || code->tenths == 300) {
    end_program(code->tenths == 300);
    after_ = After::kEnd;
    return;
  }
  if (code->tenths == 600) calls_.emit(PalletShuttle{});
  calls_.emit(ProgramStop{code->tenths == 10});
  after_ = After::kStop;
}

std::optional<double> Executor::computed(std::string_view name) const noexcept {
  constexpr double kNoMotionCode = 800.0;
  constexpr double kNoCompensationCode = 400.0;
  if (!name.starts_with('_')) return std::nullopt;
  for (const std::optional<double>& value :
       {modes_.value_of(name), spindle_.value_of(name), coolant_.value_of(name), overrides_.value_of(name),
        tools_.value_of(name), coordinates_.value_of(name)}) {
    if (value) return value;
  }
  const double motion_code = motion_.active() == nullptr ? kNoMotionCode : motion_.active()->tenths;
  return find_value(name, {{"_value", returned_.value_or(0.0)},
                           {"_value_returned", flag(returned_.has_value())},
                           {"_line", static_cast<double>(calls_.line())},
                           {"_call_level", static_cast<double>(saved_states_.call_level())},
                           {"_motion_mode", motion_code},
                           // What this interpreter does not have.
                           {"_ccomp", kNoCompensationCode},
                           {"_lathe_diameter_mode", 0.0},
                           {"_lathe_radius_mode", 1.0},
                           {"_units_per_rev", 0.0},
                           {"_remap_level", 0.0},
                           {"_task", 0.0},
                           {"_u", 0.0},
                           {"_v", 0.0},
                           {"_w", 0.0},
                           // The language is that of LinuxCNC 2.9, on a machine in mm.
                           {"_vmajor", 2.9},
                           {"_vminor", 0.0},
                           {"_metric_machine", 1.0}});
}

std::optional<double> Executor::computed(int number) const noexcept {
  if (number == kToolParameter) return tools_.current();
  return coordinates_.value_of(number);
}

}  // namespace armature::gcode
