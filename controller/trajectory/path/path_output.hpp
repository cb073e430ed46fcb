// Outputs of the tool that are switched at places of a move, without a stop.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/base/members.hpp"
#include "controller/base/misfit.hpp"

namespace armature {

struct PathOutput {
  // The start or the end of the move. A joint move with a blend ends where the next one begins.
  enum class From : std::uint8_t { kStart, kEnd };
  enum class Unit : std::uint8_t { kMm, kSeconds };
  std::uint8_t pin = 0;  // 1..16
  bool level = false;
  From from = From::kEnd;
  Unit unit = Unit::kMm;  // of a joint move only kSeconds
  // From there along the path, or in time; below 0: before. Lengths are those of the segments without rounded corners,
  // and the middle of a corner is its corner point. Times are those of the planned motion at its full rate: where
  // the arm is then is the place of the output, also under an override.
  double offset = 0.0;
  ARMATURE_MEMBERS(PathOutput, pin, level, from, unit, offset)
};

// Whether the place is on its own move, if that is as long as the offset. Outputs in time are so only without an
// offset.
[[nodiscard]] inline bool is_on_own_move(const PathOutput& output) noexcept {
  if (output.unit == PathOutput::Unit::kSeconds) return output.offset == 0.0;
  return output.from == PathOutput::From::kStart ? output.offset >= 0.0 : output.offset <= 0.0;
}

// Of one move.
struct PathOutputs {
  static constexpr std::size_t kMax = 4;
  std::array<PathOutput, kMax> list{};
  std::uint8_t count = 0;
  [[nodiscard]] constexpr const void* misfit() const noexcept { return first_misfit({{&count, count <= kMax}}); }
  ARMATURE_MEMBERS(PathOutputs, list, count)
};

[[nodiscard]] inline bool are_on_own_move(const PathOutputs& outputs) noexcept {
  return std::all_of(outputs.list.begin(), outputs.list.begin() + outputs.count, is_on_own_move);
}

}  // namespace armature
