// The transmitter of the UART: start bit, data bits from the lowest, parity, stop; each bit 16 ticks. There is no gap
// between characters. The format is that at the start of the character.
#pragma once

#include <cstdint>

#include "cosim/model/block.hpp"
#include "cosim/model/uart/line_format.hpp"
#include "cosim/model/uart/tick_clock.hpp"

namespace armature::cosim::model {

class Transmitter {
 public:
  struct Orders {
    bool waits = false;  // a character waits for the transmitter
    std::uint8_t data = 0;
    LineFormat format;
    std::int64_t divisor = 0;
    bool new_divisor = false;  // it was written at the edge before
  };
  struct Events {
    bool takes = false;  // the waiting character
    bool ends = false;   // a character, with its stop bit
  };

  Events edge(Cycles at, const Orders& orders) {
    left_ -= busy_ ? clock_.pass(at, orders.divisor) : 0;
    const bool tick = busy_ && clock_.tick(at, orders.divisor);
    Events events;
    events.ends = tick && stopping_ && left_ == 0;
    events.takes = orders.waits && orders.divisor != 0 && (!busy_ || events.ends);
    if (events.takes) {
      start(orders);
    } else if (tick) {
      count(events.ends);
    }
    if (events.takes || orders.new_divisor) clock_.restart(at, orders.divisor);
    return events;
  }

  [[nodiscard]] Cycles wakes_at(std::int64_t divisor) const { return busy_ ? clock_.after(left_, divisor) : kNever; }
  [[nodiscard]] bool is_busy() const { return busy_; }
  [[nodiscard]] bool line() const { return line_; }

 private:
  static constexpr std::int64_t kBitTicks = 16;

  void start(const Orders& orders) {
    const LineFormat& format = orders.format;
    const std::uint32_t data = orders.data & format.data_mask();
    bits_ = data | (format.parity_of(data) ? 1u << format.data_bits : 0u);
    bits_left_ = format.bits();
    stop_ticks_ = format.stop_ticks();
    busy_ = true;
    line_ = stopping_ = false;
    left_ = kBitTicks - 1;
  }

  void count(bool ends) {
    if (left_ != 0) {
      --left_;
    } else if (bits_left_ != 0) {
      line_ = (bits_ & 1u) != 0;
      bits_ >>= 1;
      --bits_left_;
      left_ = kBitTicks - 1;
    } else if (!ends) {
      line_ = stopping_ = true;
      left_ = stop_ticks_ - 1;
    } else {
      busy_ = stopping_ = false;
    }
  }

  TickClock clock_;
  bool busy_ = false, stopping_ = false;
  bool line_ = true;
  std::uint32_t bits_ = 0;  // not sent yet
  int bits_left_ = 0;
  std::int64_t left_ = 0;  // ticks before the one that ends the bit
  std::int64_t stop_ticks_ = 16;
};

}  // namespace armature::cosim::model
