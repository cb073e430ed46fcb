// The comparison of two traces as JSON, for programs.
#pragma once

#include <nlohmann/json.hpp>

#include "cosim/trace/compare.hpp"

namespace armature::cosim {

[[nodiscard]] nlohmann::ordered_json comparison_json(const Comparison& comparison);

}  // namespace armature::cosim
