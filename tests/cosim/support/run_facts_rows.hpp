// Rows and events made by hand for the tests of RunFactsCollector.
#pragma once

#include <gtest/gtest.h>

#include "cosim/report/measure/run_facts.hpp"

namespace armature::cosim::test {

inline constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

// One pulse is one count is 7.2e-4 deg; axis 2 turns against its motor, axis 3 has twice as many counts as pulses.
inline RobotSpec robot() {
  RobotSpec spec;
  spec.axes[1].gear_ratio = -50;
  spec.axes[2].encoder_lines = 5000;
  return spec;
}

struct RunFactsRows : testing::Test {
  // One tick in which axis `axis` has its reference at `reference` pulses and its encoder at `encoder` counts.
  void tick(std::int64_t reference, std::int64_t encoder, std::size_t axis = 0) {
    TraceRow row = next;
    row.telemetry.reference_pulses[axis] = Pulses{reference};
    row.telemetry.reference[axis] =
        Radians{static_cast<double>(axis == 1 ? -reference : reference) * 7.2e-4 * kRadPerDeg};
    row.telemetry.encoder[axis] = Counts{encoder};
    row.telemetry.actual[axis] =
        Radians{static_cast<double>(axis == 1 ? -encoder : encoder) * (axis == 2 ? 3.6e-4 : 7.2e-4) * kRadPerDeg};
    add(row);
  }
  void report(const Event& event, Cycles at = Cycles{0}) { collector.on_event(event, at); }
  void finish(std::int64_t taken) { report(MoveFinished{.taken = Ticks{taken}}); }
  void cut_short() { report(MoveFinished{.how = MoveFinished::How::kCutShort, .taken = Ticks{1}}); }
  void add(const TraceRow& row) {
    collector.add(row);
    next = row;
    ++next.tick;
    next.cycle += 2500;
  }

  RunFactsCollector collector{robot(), 1};
  TraceRow next;
};

}  // namespace armature::cosim::test
