// Whoever outside of the simulation talks on the serial line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace armature::cosim {

class SerialPeer {
 public:
  virtual ~SerialPeer() = default;

  // Appends at most `room` bytes that wait for the controller to `in`. Never blocks.
  virtual void exchange(std::size_t room, std::vector<std::uint8_t>& in) = 0;

  // A byte from the controller.
  virtual void send(std::uint8_t byte) = 0;
};

}  // namespace armature::cosim
