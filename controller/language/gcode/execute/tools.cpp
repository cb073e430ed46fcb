#include "controller/language/gcode/execute/tools.hpp"

namespace armature::gcode {

void Tools::add(const ToolNumbers& numbers) noexcept {
  for (int number = 1; number < kMaxTools; ++number) {
    if (numbers[static_cast<std::size_t>(number)]) add(number, Axes6{});
  }
}

Axes6* Tools::offset_of(int number) noexcept {
  std::optional<Axes6>& offset = table_[static_cast<std::size_t>(number)];
  return offset ? &*offset : nullptr;
}

std::optional<double> Tools::value_of(std::string_view name) const noexcept {
  const auto current = static_cast<double>(current_);
  const auto selected = static_cast<double>(selected_);
  // The pocket of a tool has its number.
  return find_value(name, {{"_current_tool", current},
                           {"_selected_tool", selected},
                           {"_current_pocket", current},
                           {"_selected_pocket", selected}});
}

Failure Tools::select(const Block& block) noexcept {
  if (!block.words.has('t')) return std::nullopt;
  int number = 0;
  if (const Failure failure = read_whole(block.words, 't', 0, kMaxTools - 1, number)) return failure;
  if (number != 0 && offset_of(number) == nullptr) return error_of(ErrorCode::kToolUnknown, 't', number);
  selected_ = number;
  calls_.emit(SelectTool{number});
  return std::nullopt;
}

void Tools::change(const Block& block) noexcept {
  if (block.code(Group::kToolChange) == nullptr) return;
  calls_.emit(StartChange{});
  spindle_.turn(0);
  current_ = selected_;
  calls_.emit(ChangeTool{current_});
}

}  // namespace armature::gcode
