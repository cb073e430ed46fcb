// Outputs of the tool that are switched at places of a path, without a stop.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace armature {

struct PathOutput {
  enum class From : std::uint8_t { kStart, kEnd };  // of the segment
  enum class Unit : std::uint8_t { kMm, kSeconds };
  std::uint8_t pin = 0;  // 1..16
  bool level = false;
  From from = From::kEnd;
  Unit unit = Unit::kMm;
  // From there along the path, or in time; below 0: before. Lengths are those of the segments without rounded corners,
  // and the middle of a corner is its corner point. Times are those of the planned motion at its full rate: the place
  // that the tool passes then is the place of the output, also under an override.
  double offset = 0.0;
};

// Of one segment.
struct PathOutputs {
  static constexpr std::size_t kMax = 4;
  std::array<PathOutput, kMax> list{};
  std::uint8_t count = 0;
};

}  // namespace armature
