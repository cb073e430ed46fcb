// [serial] and [[serial_send]] of a scenario, as the user wrote them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace armature::cosim {

inline constexpr std::array<std::string_view, 5> kSerialParityNames{"none", "even", "odd", "mark", "space"};

struct SerialSpec {
  std::int64_t baud = 115'200;
  std::int64_t data_bits = 8;   // 5..8
  std::string parity = "none";  // one of kSerialParityNames
  double stop_bits = 1;         // 1, 1.5 or 2
};

inline constexpr double kMaxBaudErrorPercent = 50;

enum class SerialFault { kNone, kFraming, kParity, kBreak };

struct SerialSendSpec {
  double at_s = 0;
  std::string bytes;                       // sent one after the other; empty for a break
  double baud_error_percent = 0;           // the sender's rate against `baud`
  SerialFault fault = SerialFault::kNone;  // of every byte
  double break_s = 0;                      // kBreak
  int line = 0;
};

}  // namespace armature::cosim
