// [bus] of a scenario: how accesses of the processing system reach the logic.
#pragma once

#include <cstdint>

namespace armature::cosim {

struct BusSpec {
  std::int64_t latency_cycles = 6;     // processing-system side, each way
  std::int64_t timeout_cycles = 1000;  // an access that takes longer ends the run
  double stall_probability = 0.0;      // seeded stalls on every channel, per cycle, 0..0.9
};

}  // namespace armature::cosim
