// A register access of the processing system and its response.
#pragma once

#include <cstdint>

#include "cosim/bus/bus_error.hpp"

namespace armature::cosim {

struct BusRequest {
  bool write = false;
  std::uint32_t addr = 0;
  std::uint32_t data = 0;      // write data
  std::uint8_t strobes = 0xF;  // write strobes (WSTRB), bit i for byte i
};

struct BusResponse {
  BusError error = BusError::kNone;
  std::uint32_t data = 0;  // read data
};

}  // namespace armature::cosim
