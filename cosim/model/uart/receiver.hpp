// The receiver of the UART: finds the start bit, takes the majority of ticks 7, 8 and 9 of each bit, and reports each
// character with its errors. It checks one stop bit, in whose middle the character ends.
//
// A start bit that is high in its middle is ignored. After a missing stop bit the receiver waits for a high line.
#pragma once

#include <cstdint>

#include "cosim/model/block.hpp"
#include "cosim/model/uart/line_format.hpp"
#include "cosim/model/uart/tick_clock.hpp"

namespace armature::cosim::model {

struct ReceivedCharacter {
  std::uint8_t data = 0;
  bool parity_error = false, framing_error = false, is_break = false;

  [[nodiscard]] bool is_bad() const { return parity_error || framing_error || is_break; }
};

class Receiver {
 public:
  struct Orders {
    bool line = true;  // level before the edge
    LineFormat format;
    std::int64_t divisor = 0;
    bool new_divisor = false;  // it was written at the edge before
    bool hold = false;         // a finished character is not reported yet
  };

  // Returns whether the character() is reported at this edge.
  bool edge(Cycles at, const Orders& orders);

  // `line`, `hold`: what the next edge sees.
  [[nodiscard]] Cycles wakes_at(Cycles at, const Orders& next) const;
  [[nodiscard]] const ReceivedCharacter& character() const { return character_; }

 private:
  enum class State : std::uint8_t { kAwaitHigh, kIdle, kStart, kBits, kStop, kDeliver };

  // Ticks of a bit that matter, from its start.
  static constexpr std::int64_t kFirstSample = 6, kMiddle = 8, kBitTicks = 16;

  [[nodiscard]] bool is_running() const {
    return state_ == State::kStart || state_ == State::kBits || state_ == State::kStop;
  }
  void start(const LineFormat& format);
  void sample(bool line);
  void take_bit(bool level);
  void assemble(bool stop);

  State state_ = State::kAwaitHigh;
  TickClock clock_;
  LineFormat format_;
  std::int64_t ticks_ = 0;  // of this bit, 0..15
  int ones_ = 0;            // samples of this bit that were high
  int bits_left_ = 0;
  int position_ = 0;
  std::uint32_t bits_ = 0;
  ReceivedCharacter character_;
};

}  // namespace armature::cosim::model
