// [[stream]] of a scenario, as the user wrote it, with the set-points of its file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "controller/base/axes.hpp"

namespace armature::cosim {

struct StreamSpec {
  enum class Kind { kJoints, kTool };
  struct Point {
    std::int64_t ticks = 0;    // since the first one
    PerAxis<double> values{};  // kJoints: deg, one for each axis; kTool: x, y, z [mm], roll, pitch, yaw [deg]
  };

  double at_s = 0;
  std::string file_name;           // as written, relative to the scenario
  std::optional<double> delay_ms;  // none: 2.5 times the longest interval of the file
  ProfileKind profile = ProfileKind::kTrapezoid;
  Kind kind = Kind::kJoints;
  std::vector<Point> points;  // at least two; ticks ascend from 0
  std::size_t index = 0;      // in the order of the file, from 0
  int line = 0;

  [[nodiscard]] double delay_s() const;
};

// The tag of a stream has this number and its index added: it never is that of a move.
inline constexpr std::uint32_t kFirstStreamTag = 0x0080'0000;

}  // namespace armature::cosim
