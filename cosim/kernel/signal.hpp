// What is seen of a run at pins and lines, between its rows and beside the events of the controller.
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "cosim/bus/bus_error.hpp"
#include "cosim/cpu/processor.hpp"
#include "cosim/serial/serial_event.hpp"

namespace armature::cosim {

// An output of the tool changed to a level.
struct OutputLevel {
  int pin = 1;  // 1..16
  bool level = false;
};

// The servo enables at the drives changed.
struct ServoEnables {
  std::uint8_t levels = 0;  // bit 0 is axis 1
};

// A core got an error response, which a fault of the scenario explains, and has stopped.
struct BusAbort {
  Processor::Access access;
  BusError error = BusError::kNone;
};

// The teach pendant of the scenario has completed a step.
struct PendantStepDone {
  std::string text;
};

// SerialEvent: a character or a break on the serial line.
using Signal = std::variant<OutputLevel, ServoEnables, BusAbort, SerialEvent, PendantStepDone>;

}  // namespace armature::cosim
