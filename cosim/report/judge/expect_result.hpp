// A key of [expect] and what the run gave, whether it is met or not.
#pragma once

#include <optional>
#include <string>

namespace armature::cosim {

struct ExpectResult {
  std::string key;
  std::string expected;  // in words
  std::string got;
  bool met = false;
  // From the value to the limit or the end of the tolerance, in the unit of the value; negative if the key is not met.
  // None: the values must be equal, or there is no value.
  std::optional<double> margin{};
};

}  // namespace armature::cosim
