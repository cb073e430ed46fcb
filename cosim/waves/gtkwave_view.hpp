// A view for GTKWave that begins at the first difference of two waveforms.
#pragma once

#include <cstdint>
#include <string>

#include "cosim/waves/wave_compare.hpp"

namespace armature::cosim {

// The text of the view: the cursor at the difference, the signals that differ, below them what helps to understand it.
// `unit_ps`: of time in the file that it shows.
[[nodiscard]] std::string gtkwave_view(const WaveDifference& first, std::int64_t unit_ps);

}  // namespace armature::cosim
