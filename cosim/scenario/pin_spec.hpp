// The tool's pins in a scenario, as the user wrote them. Pins are 1..kToolPins.
#pragma once

#include <cstdint>

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
};

}  // namespace armature::cosim
