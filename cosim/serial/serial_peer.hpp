// Interface of a program outside of the simulation that uses the serial line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "controller/base/units.hpp"

namespace armature::cosim {

class SerialPeer {
 public:
  virtual ~SerialPeer() = default;

  // Appends to `in` at most `room` bytes that wait for the controller. `now` is simulated time. Never blocks.
  virtual void exchange(Cycles now, std::size_t room, std::vector<std::uint8_t>& in) = 0;

  // Sends a byte from the controller. Never blocks.
  virtual void send(std::uint8_t byte) = 0;
};

}  // namespace armature::cosim
