#pragma once

#include <string_view>

namespace armature::cosim {

// The version of armature, as `armature --version` prints it: the project version of CMakeLists.txt, for example
// "0.2.0".
[[nodiscard]] std::string_view version();

}  // namespace armature::cosim
