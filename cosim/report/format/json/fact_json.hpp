// Facts as JSON.
#pragma once

#include "cosim/report/facts/fact_value.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {

// A missing value is null, and values of axes are an array. scenarios/RESULTS.md describes the other types.
[[nodiscard]] Json fact_json(const FactValue& value);

[[nodiscard]] Json vector_json(const Eigen::Vector3d& vector);

}  // namespace armature::cosim
