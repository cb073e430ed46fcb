// A character or a break on the serial line, as the log records it.
#pragma once

#include <cstdint>

#include "controller/base/units.hpp"

namespace armature::cosim {

// Direction as seen from the controller.
enum class SerialDirection : std::uint8_t { kRx, kTx };

struct SerialEvent {
  Cycles at{};  // kRx: first edge of the character; kTx: middle of its stop bit, where a receiver has it complete
  SerialDirection direction = SerialDirection::kRx;
  std::uint8_t byte = 0;
  bool parity_error = false;
  bool framing_error = false;
  bool is_break = false;
  std::int32_t baud_error_ppm = 0;  // kRx
  Cycles break_duration{};          // kRx

  [[nodiscard]] bool has_error() const { return parity_error || framing_error || is_break; }
};

}  // namespace armature::cosim
