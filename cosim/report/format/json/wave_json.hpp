// The comparison of two waveforms as JSON, for programs.
#pragma once

#include <nlohmann/json.hpp>

#include "cosim/waves/wave_compare.hpp"

namespace armature::cosim {

[[nodiscard]] nlohmann::ordered_json wave_comparison_json(const WaveComparison& comparison);

}  // namespace armature::cosim
