// Colours that people with any kind of colour vision can tell apart (Okabe and Ito's), one for each joint.
#pragma once

#include <array>
#include <string_view>

namespace armature::cosim {

inline constexpr std::array<std::string_view, 6> kJointColors{"#0072b2", "#d55e00", "#009e73",
                                                              "#cc79a7", "#e69f00", "#56b4e9"};

}  // namespace armature::cosim
