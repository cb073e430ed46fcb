// Facts as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "cosim/report/facts/fact_value.hpp"

namespace armature::cosim {

using Json = nlohmann::ordered_json;  // keys in the order of writing

// No value is null; values of axes are an array; the others are as scenarios/RESULTS.md describes them.
[[nodiscard]] Json fact_json(const FactValue& value);

[[nodiscard]] Json vector_json(const Eigen::Vector3d& vector);

}  // namespace armature::cosim
