// "No event": later than every cycle of a run.
#pragma once

#include <cstdint>
#include <limits>

#include "controller/base/units.hpp"

namespace armature::cosim {

inline constexpr Cycles kNever{std::numeric_limits<std::int64_t>::max()};

}  // namespace armature::cosim
