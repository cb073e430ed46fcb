// Coordinate systems, offsets, tools' lengths and stored places.
#include "controller/language/gcode/executor.hpp"

namespace armature::gcode {
namespace {

constexpr std::array<std::int16_t, kSystems> kSystemCodes{540, 550, 560, 570, 580, 590, 591, 592, 593};

constexpr int system_parameter(int system) noexcept {
  return kSystemsParameter + (system - 1) * kSystemInterval;
}

}  // namespace

Executor::Failure Executor::set_tool_offset(const Block& block) noexcept {
  const CodeInfo* code = block.code(Group::kToolLength);
  if (code == nullptr) return std::nullopt;
  Offsets changed = offsets_;
  if (code->tenths == 490) {
    changed.tool = {};
  } else if (code->tenths == 431) {
    changed.tool = with_words(block.words, changed.tool);
  } else {
    int tool = 0;
    if (block.words.has('h')) {
      if (const Failure failure = whole(block.words, 'h', 0, kMaxTools - 1, tool)) return failure;
    }
    if (tool == 0) tool = modes_.tool;
    const std::optional<Axes6>& data = tools_[static_cast<std::size_t>(tool)];
    if (tool != 0 && !data) return error_of(ErrorCode::kToolUnknown, 'h', tool);
    changed.tool = data.value_or(Axes6{});
  }
  apply_offsets(changed);
  emit(UseToolLengthOffset{offsets_.tool});
  return std::nullopt;
}

void Executor::set_system(const Block& block) noexcept {
  const CodeInfo* code = block.code(Group::kCoordinates);
  if (code == nullptr) return;
  int system = 1;
  while (kSystemCodes[static_cast<std::size_t>(system - 1)] != code->tenths) ++system;
  change_system(system);
}

void Executor::change_system(int system) noexcept {
  if (system == static_cast<int>(parameters_.at(kSystemParameter))) return;
  parameters_.at(kSystemParameter) = system;
  apply_offsets(with_system(system));
  emit(SetG5xOffset{.index = system, .offset = offsets_.g5x});
  emit(SetG92Offset{offsets_.g92});
  emit(SetXyRotation{offsets_.rotation_deg});
}

Executor::Failure Executor::execute_once(const Block& block) noexcept {
  const CodeInfo* code = block.code(Group::kOnce);
  if (code == nullptr) return std::nullopt;
  switch (code->tenths) {
    case 100:
      return set_data(block);
    case 280:
      go_home(block, kHomeParameter);
      break;
    case 300:
      go_home(block, kSecondHomeParameter);
      break;
    case 281:
      store(kHomeParameter, offsets_.machine(place_));
      break;
    case 301:
      store(kSecondHomeParameter, offsets_.machine(place_));
      break;
    case 520:
    case 920:
    case 921:
    case 922:
    case 923:
      set_g92(block, *code);
      break;
    default:
      break;
  }
  return std::nullopt;
}

Executor::Failure Executor::set_data(const Block& block) noexcept {
  constexpr int kSystem = 2;
  constexpr int kSystemFromPlace = 20;
  int kind = 0;
  if (const Failure failure = whole(block.words, 'l', 1, kSystemFromPlace, kind)) return failure;
  if (kind == 1 || kind == 10 || kind == 11) return set_tool_data(block, kind);
  if (kind == kSystem || kind == kSystemFromPlace) return set_system_data(block, kind);
  return error_of(ErrorCode::kWordRange, 'l');
}

Executor::Failure Executor::set_tool_data(const Block& block, int kind) noexcept {
  int tool = 0;
  if (const Failure failure = whole(block.words, 'p', 1, kMaxTools - 1, tool)) return failure;
  std::optional<Axes6>& data = tools_[static_cast<std::size_t>(tool)];
  if (!data) return error_of(ErrorCode::kToolUnknown, 'p', tool);
  // L10: the present place gets the axis words with this tool; L11: with it in coordinate system 9.
  Offsets without = kind == 11 ? with_system(kSystems) : offsets_;
  without.tool = {};
  if (kind == 11) without.g92 = {};
  const Axes6 place = without.place(offsets_.machine(place_));
  if (kind == 1) {
    *data = with_words(block.words, *data);
  } else {
    const Axes6 wanted = with_words(block.words, place);
    for (std::size_t i = 0; i < kAxes; ++i) {
      if (block.words.has(kAxisLetters[i])) (*data)[i] = place[i] - wanted[i];
    }
  }
  emit(SetToolTableEntry{.number = tool, .offset = *data});
  return std::nullopt;
}

Executor::Failure Executor::set_system_data(const Block& block, int kind) noexcept {
  const Words& words = block.words;
  const auto active = static_cast<int>(parameters_.at(kSystemParameter));
  int system = 0;
  if (const Failure failure = whole(words, 'p', 0, kSystems, system)) return failure;
  if (system == 0) system = active;
  Offsets changed = with_system(system);
  if (words.has('r')) {
    if (kind != 2) return error_of(ErrorCode::kWordNotUsed, 'r');
    changed.rotation_deg = words.get('r');
  }
  if (kind == 2) {
    changed.g5x = with_words(words, changed.g5x);
  } else {
    // The origin moves so that the present place gets the axis words.
    const Axes6 machine = offsets_.machine(place_);
    const Axes6 wanted = with_words(words, changed.place(machine));
    const Axes6 reached = changed.machine(wanted);
    for (std::size_t i = 0; i < kAxes; ++i) changed.g5x[i] += machine[i] - reached[i];
  }
  store(system_parameter(system), changed.g5x);
  parameters_.at(system_parameter(system) + kSystemRotation) = changed.rotation_deg;
  if (system != active) return std::nullopt;
  apply_offsets(changed);
  emit(SetG5xOffset{.index = system, .offset = offsets_.g5x});
  emit(SetXyRotation{offsets_.rotation_deg});
  return std::nullopt;
}

void Executor::set_g92(const Block& block, const CodeInfo& code) noexcept {
  Offsets changed = offsets_;
  switch (code.tenths) {
    case 520:
      changed.g92 = with_words(block.words, offsets_.g92);
      break;
    case 920: {
      const Axes6 wanted = with_words(block.words, place_);
      for (std::size_t i = 0; i < kAxes; ++i) changed.g92[i] += place_[i] - wanted[i];
      break;
    }
    case 923:
      changed.g92 = stored(kG92Parameter);
      break;
    default:
      changed.g92 = {};
      break;
  }
  parameters_.at(kG92ActiveParameter) = code.tenths == 921 || code.tenths == 922 ? 0.0 : 1.0;
  if (code.tenths != 922) store(kG92Parameter, changed.g92);
  apply_offsets(changed);
  emit(SetG92Offset{offsets_.g92});
}

void Executor::apply_offsets(const Offsets& offsets) noexcept {
  const Axes6 machine = offsets_.machine(place_);
  offsets_ = offsets;
  place_ = offsets_.place(machine);
}

Offsets Executor::with_system(int system) const noexcept {
  Offsets offsets = offsets_;
  offsets.g5x = stored(system_parameter(system));
  offsets.rotation_deg = parameters_.at(system_parameter(system) + kSystemRotation);
  return offsets;
}

Axes6 Executor::stored(int parameter) const noexcept {
  Axes6 axes{};
  for (std::size_t i = 0; i < kAxes; ++i) axes[i] = parameters_.at(parameter + static_cast<int>(i));
  return axes;
}

void Executor::store(int parameter, const Axes6& axes) noexcept {
  for (std::size_t i = 0; i < kAxes; ++i) parameters_.at(parameter + static_cast<int>(i)) = axes[i];
}

}  // namespace armature::gcode
