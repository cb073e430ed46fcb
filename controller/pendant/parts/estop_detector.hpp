// Finds the emergency stop in the bytes of the line, before frames are looked for: four bytes 0xEE in a row.
//
// Valid frames never have more than three in a row: byte 0 begins with a kind that is not 0xE, the bytes 1 and 2 are
// below 128, and the highest byte of a payload is at most 0x07 or at least 0xF8.
#pragma once

#include <cstdint>

namespace armature::pendant {

inline constexpr std::uint8_t kEstopByte = 0xEE;
inline constexpr int kEstopRun = 4;     // that the controller takes for an emergency stop
inline constexpr int kEstopBytes = 16;  // that the pendant sends: the UART then interrupts after four of them at least

class EstopDetector {
 public:
  // True for the byte that completes a run. A longer run is the same emergency stop, until another byte comes.
  [[nodiscard]] bool push(std::uint8_t byte) noexcept {
    if (byte != kEstopByte) {
      run_ = 0;
      return false;
    }
    if (run_ == kEstopRun) return false;
    return ++run_ == kEstopRun;
  }

 private:
  int run_ = 0;
};

}  // namespace armature::pendant
