// The line of a terminal pendant: a serial device, a pseudo-terminal, or a TCP port of this machine.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cosim/net/file_descriptor.hpp"

namespace armature::cosim {

class DeviceLine {
 public:
  // `address`: a path, or tcp:PORT. A terminal gets the settings of the protocol: 115200 baud, 8N1, raw. `token`: sent
  // first over TCP, as a run with --serial tcp:PORT asks for it; empty: nothing is sent. Waits for the answer. Throws
  // InputError, also if the other end refuses the token.
  DeviceLine(const std::string& address, const std::string& token);

  // Waits up to `timeout_ms` for bytes or for input on `other`, and returns the bytes that came. None of these calls
  // blocks longer. Throws InputError when the other end has closed the line.
  [[nodiscard]] std::vector<std::uint8_t> read(int other, int timeout_ms);
  // Sends what the line accepts now, and keeps the rest for the next call.
  void write(std::span<const std::uint8_t> bytes);

 private:
  std::string address_;
  FileDescriptor descriptor_;
  std::vector<std::uint8_t> unsent_;
};

}  // namespace armature::cosim
