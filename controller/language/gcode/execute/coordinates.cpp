#include "controller/language/gcode/execute/coordinates.hpp"

#include <algorithm>

namespace armature::gcode {
namespace {

constexpr std::array<std::int16_t, 9> kSystemCodes{540, 550, 560, 570, 580, 590, 591, 592, 593};
constexpr int kSystems = static_cast<int>(kSystemCodes.size());

constexpr int system_parameter(int system) noexcept {
  return kSystemsParameter + (system - 1) * kSystemInterval;
}

// The axis with a letter; kAxes: none.
std::size_t axis_of(char letter) noexcept {
  return static_cast<std::size_t>(std::ranges::find(kAxisLetters, letter) - kAxisLetters.begin());
}

}  // namespace

std::optional<double> Coordinates::value_of(std::string_view name) const noexcept {
  constexpr std::string_view kMachinePlace = "_abs_";
  const std::size_t axis = axis_of(name.back());
  if (name.size() == 2 && axis < kAxes) return value_of(kPlaceParameter + static_cast<int>(axis));
  if (name.size() == kMachinePlace.size() + 1 && name.starts_with(kMachinePlace) && axis < kAxes) {
    return machine()[axis] / (axis < 3 ? modes_.unit_mm() : 1.0);
  }
  const int code = 540 + (system() <= 6 ? (system() - 1) * 10 : 50 + system() - 6);
  return find_value(name, {{"_coord_system", static_cast<double>(code)}, {"_tool_offset", flag(has_tool_offset())}});
}

std::optional<double> Coordinates::value_of(int parameter) const noexcept {
  const int axis = parameter - kPlaceParameter;
  if (axis < 0 || axis >= static_cast<int>(kAxes)) return std::nullopt;
  return place_[static_cast<std::size_t>(axis)] / (axis < 3 ? modes_.unit_mm() : 1.0);
}

void Coordinates::begin_program(const Axes6& machine) noexcept {
  parameters_.at(kSystemParameter) = system();
  offsets_ = {};
  offsets_ = with_system(system());
  if (parameters_.at(kG92ActiveParameter) != 0.0) offsets_.g92 = stored(kG92Parameter);
  place_ = offsets_.place(machine);
  calls_.emit(SetG5xOffset{.index = system(), .offset = offsets_.g5x});
  calls_.emit(SetG92Offset{offsets_.g92});
  calls_.emit(SetXyRotation{offsets_.rotation_deg});
}

void Coordinates::end_program() noexcept {
  parameters_.at(kSystemParameter) = 1.0;
  apply(with_system(1));
  calls_.emit(SetG5xOffset{.index = 1, .offset = offsets_.g5x});
  calls_.emit(SetXyRotation{offsets_.rotation_deg});
}

Axes6 Coordinates::target(const Words& words) const noexcept {
  if (!modes_.active().incremental) return with_words(words, place_);
  Axes6 end = with_words(words, Axes6{});
  for (std::size_t i = 0; i < kAxes; ++i) end[i] += place_[i];
  return end;
}

Axes6 Coordinates::machine_target(const Words& words) const noexcept {
  return offsets_.place(with_words(words, machine()));
}

Failure Coordinates::set_tool_offset(const Block& block) noexcept {
  const CodeInfo* code = block.code(Group::kToolLength);
  if (code == nullptr) return std::nullopt;
  if (code->tenths == 490) {
    use_tool_offset({});
  } else if (code->tenths == 431) {
    use_tool_offset(with_words(block.words, offsets_.tool));
  } else {
    int tool = 0;
    if (block.words.has('h')) {
      if (const Failure failure = read_whole(block.words, 'h', 0, kMaxTools - 1, tool)) return failure;
    }
    if (tool == 0) tool = tools_.current();
    const Axes6* offset = tools_.offset_of(tool);
    if (tool != 0 && offset == nullptr) return error_of(ErrorCode::kToolUnknown, 'h', tool);
    use_tool_offset(offset == nullptr ? Axes6{} : *offset);
  }
  return std::nullopt;
}

bool Coordinates::has_tool_offset() const noexcept {
  return std::ranges::any_of(offsets_.tool, [](double value) { return value != 0.0; });
}

void Coordinates::use_tool_offset(const Axes6& offset) noexcept {
  Offsets changed = offsets_;
  changed.tool = offset;
  apply(changed);
  calls_.emit(UseToolLengthOffset{offset});
}

void Coordinates::set_system(const Block& block) noexcept {
  const CodeInfo* code = block.code(Group::kCoordinates);
  if (code == nullptr) return;
  change_system(1 + static_cast<int>(std::ranges::find(kSystemCodes, code->tenths) - kSystemCodes.begin()));
}

int Coordinates::system() const noexcept {
  const double system = parameters_.at(kSystemParameter);
  return system >= 1.0 && system < kSystems + 1.0 ? static_cast<int>(system) : 1;
}

void Coordinates::change_system(int system) noexcept {
  if (system == this->system()) return;
  parameters_.at(kSystemParameter) = system;
  apply(with_system(system));
  calls_.emit(SetG5xOffset{.index = system, .offset = offsets_.g5x});
  calls_.emit(SetG92Offset{offsets_.g92});
  calls_.emit(SetXyRotation{offsets_.rotation_deg});
}

Failure Coordinates::set_data(const Block& block) noexcept {
  constexpr int kSystem = 2;
  constexpr int kSystemFromPlace = 20;
  int kind = 0;
  if (const Failure failure = read_whole(block.words, 'l', 1, kSystemFromPlace, kind)) return failure;
  if (kind == 1 || kind == 10 || kind == 11) return set_tool_data(block, kind);
  if (kind == kSystem || kind == kSystemFromPlace) return set_system_data(block, kind);
  return error_of(ErrorCode::kWordRange, 'l');
}

Failure Coordinates::set_tool_data(const Block& block, int kind) noexcept {
  int tool = 0;
  if (const Failure failure = read_whole(block.words, 'p', 1, kMaxTools - 1, tool)) return failure;
  Axes6* const offset = tools_.offset_of(tool);
  if (offset == nullptr) return error_of(ErrorCode::kToolUnknown, 'p', tool);
  // L10: the present place gets the axis words with this tool; L11: with it in coordinate system 9.
  Offsets without = kind == 11 ? with_system(kSystems) : offsets_;
  without.tool = {};
  if (kind == 11) without.g92 = {};
  const Axes6 place = without.place(machine());
  if (kind == 1) {
    *offset = with_words(block.words, *offset);
  } else {
    const Axes6 wanted = with_words(block.words, place);
    for (std::size_t i = 0; i < kAxes; ++i) {
      if (block.words.has(kAxisLetters[i])) (*offset)[i] = place[i] - wanted[i];
    }
  }
  calls_.emit(SetToolTableEntry{.number = tool, .offset = *offset});
  return std::nullopt;
}

Failure Coordinates::set_system_data(const Block& block, int kind) noexcept {
  const Words& words = block.words;
  int system = 0;
  if (const Failure failure = read_whole(words, 'p', 0, kSystems, system)) return failure;
  if (system == 0) system = this->system();
  Offsets changed = with_system(system);
  if (words.has('r')) {
    if (kind != 2) return error_of(ErrorCode::kWordNotUsed, 'r');
    changed.rotation_deg = words.get('r');
  }
  if (kind == 2) {
    changed.g5x = with_words(words, changed.g5x);
  } else {
    // The origin moves so that the present place gets the axis words.
    const Axes6 place = machine();
    const Axes6 reached = changed.machine(with_words(words, changed.place(place)));
    for (std::size_t i = 0; i < kAxes; ++i) changed.g5x[i] += place[i] - reached[i];
  }
  store(system_parameter(system), changed.g5x);
  parameters_.at(system_parameter(system) + kSystemRotation) = changed.rotation_deg;
  if (system != this->system()) return std::nullopt;
  apply(changed);
  calls_.emit(SetG5xOffset{.index = system, .offset = offsets_.g5x});
  calls_.emit(SetXyRotation{offsets_.rotation_deg});
  return std::nullopt;
}

void Coordinates::set_g92(const Block& block) noexcept {
  const int tenths = block.code(Group::kOnce)->tenths;
  Offsets changed = offsets_;
  switch (tenths) {
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
  parameters_.at(kG92ActiveParameter) = tenths == 921 || tenths == 922 ? 0.0 : 1.0;
  if (tenths != 922) store(kG92Parameter, changed.g92);
  apply(changed);
  calls_.emit(SetG92Offset{offsets_.g92});
}

Axes6 Coordinates::with_words(const Words& words, Axes6 axes) const noexcept {
  for (std::size_t i = 0; i < kAxes; ++i) {
    if (words.has(kAxisLetters[i])) axes[i] = words.get(kAxisLetters[i]) * (i < 3 ? modes_.unit_mm() : 1.0);
  }
  return axes;
}

void Coordinates::apply(const Offsets& offsets) noexcept {
  const Axes6 machine = this->machine();
  offsets_ = offsets;
  place_ = offsets_.place(machine);
}

Offsets Coordinates::with_system(int system) const noexcept {
  Offsets offsets = offsets_;
  offsets.g5x = stored(system_parameter(system));
  offsets.rotation_deg = parameters_.at(system_parameter(system) + kSystemRotation);
  return offsets;
}

Axes6 Coordinates::stored(int parameter) const noexcept {
  Axes6 axes{};
  for (std::size_t i = 0; i < kAxes; ++i) axes[i] = parameters_.at(parameter + static_cast<int>(i));
  return axes;
}

void Coordinates::store(int parameter, const Axes6& axes) noexcept {
  for (std::size_t i = 0; i < kAxes; ++i) parameters_.at(parameter + static_cast<int>(i)) = axes[i];
}

}  // namespace armature::gcode
