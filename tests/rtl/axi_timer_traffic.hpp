// Random writes to the timer pair, with values that make things happen often: short periods, modes that need several
// bits at once.
#pragma once

#include <cstdint>

#include "tests/rtl/axi_timer_bits.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test::axi_timer {

struct TimerWrite {
  std::uint16_t addr = 0;
  std::uint32_t data = 0;
  std::uint8_t strobe = 0xF;
};

class TimerTraffic {
 public:
  explicit TimerTraffic(SplitMix& random) : random_{random} {}

  // Begins a stretch of clocks that stays with one kind of mode, or with none. Periods are mostly below `span` clocks.
  void begin_stretch(std::uint32_t span) {
    favourite_ = random_.below(8);
    span_ = span;
  }

  TimerWrite write() {
    TimerWrite write;
    const unsigned timer = random_.below(2);
    const bool start = random_.below(3) == 0;
    write.addr = static_cast<std::uint16_t>(0x10 * timer + (start ? 4 : 0));
    if (random_.below(8) == 0) write.strobe = static_cast<std::uint8_t>(random_.below(16));
    write.data = start ? near_an_end() : mode(timer);
    return write;
  }

 private:
  std::uint32_t near_an_end() {
    const bool down = random_.below(2) != 0;
    switch (random_.below(8)) {
      case 0:
        return static_cast<std::uint32_t>(random_.next());
      case 1:
      case 2:
      case 3:
        return before_end(down, 0);
      default:
        return before_end(down, random_.below(span_));
    }
  }

  // Mode bits that let the timers run most of the time.
  std::uint32_t mode(unsigned timer) {
    auto bits = static_cast<std::uint32_t>(random_.next());
    if (random_.below(4) != 0) bits &= ~kLoad;
    if (random_.below(4) != 0) bits |= kRun;
    if (random_.below(4) != 0) bits &= ~kRunAll;
    switch (favourite_ < 4 ? favourite_ : random_.below(4)) {
      case 0:
        return bits | kCapture | kCapturePin;
      case 1:
        return (bits | kPwm | kGenerate | kReload) & ~(kCapture | kCascade);
      case 2:
        return (bits | (timer == 0 ? kCascade : 0u)) & ~kCapture;
      default:
        return bits;
    }
  }

  SplitMix& random_;
  std::uint32_t favourite_ = 0;  // case of mode(); from 4 on any
  std::uint32_t span_ = 14;
};

}  // namespace armature::test::axi_timer
