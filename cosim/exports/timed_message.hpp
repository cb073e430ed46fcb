// A message of an export with its moment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace armature::cosim {

struct TimedMessage {
  std::uint64_t time_ns = 0;  // of simulated time
  std::size_t channel = 0;    // a RunChannel
  std::string json;
};

}  // namespace armature::cosim
