#include "cosim/waves/gtkwave_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace armature::cosim {
namespace {

// How GTKWave shows a value.
constexpr int kHexadecimal = 22, kDecimal = 420, kBinary = 28, kText = 820;

struct ContextSignal {
  int format;
  std::string_view name;
};
constexpr std::array<ContextSignal, 8> kContext{{{kDecimal, "top.software.tick[31:0]"},
                                                 {kText, "top.software.motion[63:0]"},
                                                 {kText, "top.software.bus_register[223:0]"},
                                                 {kBinary, "top.arm_soc.trigger_o"},
                                                 {kBinary, "top.arm_soc.step_o[5:0]"},
                                                 {kBinary, "top.arm_soc.dir_o[5:0]"},
                                                 {kBinary, "top.arm_soc.servo_on_o[5:0]"},
                                                 {kBinary, "top.arm_soc.irq_o[4:0]"}}};

constexpr std::size_t kMaxSignals = 40;
constexpr std::int64_t kBeforePs = 1'400'000;  // shown in front of the cursor: 70 cycles
constexpr double kFrameLog2Ps = 19;            // 200 pixels of the screen show 2^19 ps, about 26 cycles

// The zoom is the negative logarithm of the units of time in 200 pixels.
double zoom_of(std::int64_t unit_ps) {
  double zoom = -kFrameLog2Ps;
  for (std::int64_t unit = unit_ps; unit > 1; unit /= 2) zoom += 1;
  return zoom;
}

}  // namespace

std::string gtkwave_view(const WaveDifference& first, std::int64_t unit_ps) {
  constexpr int kOtherMarkers = 26;
  std::string text = fmt::format("[*] Written by armature compare: gtkwave FILE VIEW\n*{:.6f} {}", zoom_of(unit_ps),
                                 first.at_ps / unit_ps);
  for (int i = 0; i < kOtherMarkers; ++i) text += " -1";
  text += fmt::format("\n[timestart] {}\n[size] 1500 1000\n[pos] -1 -1\n[sst_width] 230\n[signals_width] 300\n",
                      std::max<std::int64_t>(first.at_ps - kBeforePs, 0) / unit_ps);
  text += "@200\n-they differ at the cursor\n";
  for (std::size_t i = 0; i < std::min(first.signals.size(), kMaxSignals); ++i) {
    const WaveSignal& signal = first.signals[i].signal;
    const int format = is_wave_text(signal) ? kText : signal.bits == 1 ? kBinary : kHexadecimal;
    text += fmt::format("@{}\n[color] 1\n{}{}\n", format, signal.name, signal.range);
  }
  text += "@200\n-\n";
  for (const ContextSignal& signal : kContext) text += fmt::format("@{}\n{}\n", signal.format, signal.name);
  return text;
}

}  // namespace armature::cosim
