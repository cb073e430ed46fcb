// Facts as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "cosim/report/facts/fact_value.hpp"

namespace armature::cosim {

using Json = nlohmann::ordered_json;  // keys in the order of writing

// A missing value is null, and values of axes are an array. scenarios/RESULTS.md describes the other types.
[[nodiscard]] Json fact_json(const FactValue& value);

[[nodiscard]] Json vector_json(const Eigen::Vector3d& vector);

}  // namespace armature::cosim
