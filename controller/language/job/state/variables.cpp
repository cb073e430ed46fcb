#include "controller/language/job/state/variables.hpp"

#include <algorithm>
#include <cmath>

namespace armature::job {
namespace {

struct VariableRange {
  double least = 0.0, most = 0.0;
  bool whole = true;
};
constexpr std::array<VariableRange, 4> kVariableRanges{
    {{0.0, 255.0}, {-32'768.0, 32'767.0}, {-2'147'483'648.0, 2'147'483'647.0}, {-3.4e38, 3.4e38, false}}};

// An index that is a whole number below `count`; `count` otherwise.
std::size_t index_below(double number, std::size_t count) noexcept {
  if (!(number >= 0.0 && number < static_cast<double>(count)) || std::floor(number) != number) return count;
  return static_cast<std::size_t>(number);
}

}  // namespace

void Variables::reset() noexcept {
  for (auto& type : globals_) type.fill(0.0);
  positions_.fill({});
  depth_ = 0;
  returned_ = 0.0;
}

void Variables::set_positions(const ProgramMemory& memory) noexcept {
  for (const Position& stated : std::span{memory.positions}.first(memory.position_count)) {
    if (stated.letter != PositionLetter::kP) continue;
    PositionValue* variable = position({VariableType::kP, false, static_cast<double>(stated.number)});
    if (variable != nullptr) *variable = PositionValue::of(stated);
  }
}

Alarm Variables::enter(const JobInfo& job) noexcept {
  if (depth_ == calls_.size()) return Alarm::kCalls;
  Call call;
  std::size_t number = 0, position = 0;
  if (depth_ > 0) {
    const Call& outer = calls_[depth_ - 1];
    number = std::size_t{outer.first.back()} + outer.count.back();
    position = std::size_t{outer.first_position} + outer.positions;
  }
  for (std::size_t type = 0; type < kNumericTypes; ++type) {
    call.first[type] = static_cast<std::uint16_t>(number);
    call.count[type] = job.locals[type];
    number += job.locals[type];
  }
  call.first_position = static_cast<std::uint16_t>(position);
  call.positions = job.locals[static_cast<std::size_t>(VariableType::kP)];
  position += call.positions;
  if (number > local_numbers_.size() || position > local_positions_.size()) return Alarm::kLocals;
  std::fill(local_numbers_.begin() + call.first[0], local_numbers_.begin() + static_cast<std::ptrdiff_t>(number), 0.0);
  std::fill(local_positions_.begin() + call.first_position,
            local_positions_.begin() + static_cast<std::ptrdiff_t>(position), PositionValue{});
  calls_[depth_++] = call;
  return Alarm::kNone;
}

void Variables::leave() noexcept {
  if (depth_ > 0) --depth_;
}

const double* Variables::find(const VariableId& id) const noexcept {
  const auto type = static_cast<std::size_t>(id.type);
  if (type >= kNumericTypes) return nullptr;
  if (!id.local) {
    const std::size_t at = index_below(id.number, globals_[type].size());
    return at < globals_[type].size() ? &globals_[type][at] : nullptr;
  }
  if (depth_ == 0) return nullptr;
  const Call& call = calls_[depth_ - 1];
  const std::size_t at = index_below(id.number, call.count[type]);
  return at < call.count[type] ? &local_numbers_[call.first[type] + at] : nullptr;
}

Alarm Variables::load(const VariableId& id, double& value) const noexcept {
  const double* variable = find(id);
  if (variable == nullptr) return Alarm::kIndex;
  value = *variable;
  return Alarm::kNone;
}

Alarm Variables::store(const VariableId& id, double value) noexcept {
  auto* variable = const_cast<double*>(find(id));
  if (variable == nullptr) return Alarm::kIndex;
  const VariableRange& range = kVariableRanges[static_cast<std::size_t>(id.type)];
  const double stored = !range.whole ? value : value < 0.0 ? -std::floor(-value) : std::floor(value);
  if (!(stored >= range.least && stored <= range.most)) return Alarm::kRange;
  *variable = stored + 0.0;  // no negative zero
  return Alarm::kNone;
}

PositionValue* Variables::position(const VariableId& id) noexcept {
  if (id.type != VariableType::kP) return nullptr;
  if (!id.local) {
    const std::size_t at = index_below(id.number, positions_.size());
    return at < positions_.size() ? &positions_[at] : nullptr;
  }
  if (depth_ == 0) return nullptr;
  const Call& call = calls_[depth_ - 1];
  const std::size_t at = index_below(id.number, call.positions);
  return at < call.positions ? &local_positions_[call.first_position + at] : nullptr;
}

}  // namespace armature::job
