// A place in a run: tick, cycle and axis.
#pragma once

#include <cstdint>

#include "controller/base/units.hpp"

namespace armature::cosim {

struct RunPlace {
  // The row of the trace. For an event between two triggers, the tick that is under way: its row shows the result.
  std::int64_t tick = 0;
  Cycles at{};            // for a row, its trigger; for an event, its own cycle
  std::uint8_t axis = 0;  // 1..6; 0: no single axis
};

}  // namespace armature::cosim
