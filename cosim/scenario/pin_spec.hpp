// The tool's pins in a scenario, as the user wrote them. Pins are 1..kToolPins.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace armature::cosim {

inline constexpr std::int64_t kToolPins = 16;  // outputs, and as many inputs

// [[input]]: from `at_s` on the input has this level. All are low before.
struct InputSpec {
  double at_s = 0;
  std::int64_t pin = 1;
  bool level = false;
  int line = 0;
};

// [[expect.output]]: a change of an output.
struct OutputChangeSpec {
  double at_s = 0;
  std::int64_t pin = 1;
  bool level = false;
  std::optional<std::array<double, 3>> tcp_mm{};  // tool centre point of the set-points at that time, base frame
  double tcp_tolerance_mm = 0.01;
};

// [[move.output]]: an output at a place of a move. At most one of the distances is given; none: at the place itself.
struct PathOutputSpec {
  std::int64_t pin = 1;
  bool level = false;
  std::string from = "end";  // "start" | "end"
  std::optional<double> before_mm{}, after_mm{}, before_s{}, after_s{};
};

}  // namespace armature::cosim
