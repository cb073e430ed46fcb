// Registers and bits of the AXI Timer v2.0, from its description and independent of the generated header.
#pragma once

#include <cstdint>

namespace armature::test::axi_timer {

inline constexpr std::uint32_t kCapture = 1u << 0, kDown = 1u << 1, kGenerate = 1u << 2, kCapturePin = 1u << 3,
                               kReload = 1u << 4, kLoad = 1u << 5, kIrq = 1u << 6, kRun = 1u << 7, kFlag = 1u << 8,
                               kPwm = 1u << 9, kRunAll = 1u << 10, kCascade = 1u << 11;
inline constexpr std::uint32_t kMax = 0xFFFF'FFFFu;

// Counter value `span` clocks before the end of a period.
constexpr std::uint32_t before_end(bool down, std::uint32_t span) {
  return down ? span : kMax - span;
}

}  // namespace armature::test::axi_timer
