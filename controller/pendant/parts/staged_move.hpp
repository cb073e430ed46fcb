// The coordinates and options that the pendant sends before a move. A check value covers them, because each of them
// comes in a frame of its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/pendant/protocol/crc32.hpp"
#include "controller/pendant/protocol/frame_table.hpp"

namespace armature::pendant {

class StagedMove {
 public:
  static constexpr std::size_t kPoints = 2, kCoordinates = 6, kOptions = 2;
  static constexpr std::size_t kParametersOfPoint = 8;  // of Opcode::kTarget
  using Point = std::array<std::int32_t, kCoordinates>;

  // False when no such coordinate exists.
  [[nodiscard]] bool stage_target(std::size_t parameter, std::int32_t value) noexcept {
    const std::size_t point = parameter / kParametersOfPoint, coordinate = parameter % kParametersOfPoint;
    if (point >= kPoints || coordinate >= kCoordinates) return false;
    points_[point][coordinate] = value;
    staged_[point] |= 1u << coordinate;
    return true;
  }
  void stage_option(MoveOption option, std::int32_t value) noexcept {
    options_[static_cast<std::size_t>(option)] = value;
  }
  void clear() noexcept { *this = StagedMove{}; }

  [[nodiscard]] const Point& point(std::size_t index) const noexcept { return points_[index]; }
  // Of the largest value.
  [[nodiscard]] double share(MoveOption option, double otherwise) const noexcept {
    const std::optional<std::int32_t>& value = options_[static_cast<std::size_t>(option)];
    return value ? *value / 10'000.0 : otherwise;
  }

  // True when exactly the first `coordinates` of the first `points` are staged.
  [[nodiscard]] bool complete(std::size_t points, std::size_t coordinates) const noexcept {
    for (std::size_t i = 0; i < kPoints; ++i) {
      if (staged_[i] != (i < points ? (1u << coordinates) - 1u : 0u)) return false;
    }
    return true;
  }
  [[nodiscard]] std::int32_t check() const noexcept {
    Crc32 crc;
    for (std::size_t i = 0; i < kPoints; ++i) {
      for (std::size_t k = 0; k < kCoordinates; ++k) {
        if ((staged_[i] >> k & 1u) != 0) crc.add(points_[i][k]);
      }
    }
    for (const std::optional<std::int32_t>& option : options_) {
      if (option) crc.add(*option);
    }
    return crc.check();
  }

 private:
  std::array<Point, kPoints> points_{};
  std::array<std::uint32_t, kPoints> staged_{};  // bit i for coordinate i
  std::array<std::optional<std::int32_t>, kOptions> options_{};
};

}  // namespace armature::pendant
