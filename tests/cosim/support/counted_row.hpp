// Rows of a trace for tests.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cosim/trace/trace_row.hpp"

namespace armature::cosim::test {

// A row of a motion. From tick 1 on each of its integer columns has another value in each axis.
[[nodiscard]] inline TraceRow counted_row(std::int64_t tick) {
  TraceRow row;
  row.tick = tick;
  row.telemetry.state = MotionState::kMoving;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const auto n = static_cast<std::int64_t>(i + 1);
    row.telemetry.commanded[i] = Pulses{tick * n};
    row.pin_pulses[i] = tick * n - 1;
    row.telemetry.encoder[i] = Counts{-tick * n};
    row.telemetry.correction[i] = Pulses{n};
  }
  return row;
}

}  // namespace armature::cosim::test
