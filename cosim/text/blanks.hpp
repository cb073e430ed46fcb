#pragma once

#include <string_view>

namespace armature::cosim {

// What separates words in a line of a request.
inline constexpr std::string_view kBlanks = " \t";

}  // namespace armature::cosim
