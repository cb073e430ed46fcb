// Reads the characters off a serial line, as a UART does: a falling edge of the idle line begins one, every bit is
// sampled in its middle, counted from that edge, and a start bit that is high in its middle was none.
//
// Of the stop time the first bit is judged, and the receiver is ready for the next falling edge from its middle on:
// after a missing stop bit that takes a high line first.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "controller/core/units.hpp"
#include "cosim/serial/serial_format.hpp"

namespace armature::cosim {

struct ReceivedCharacter {
  std::uint8_t data = 0;
  bool parity_error = false;
  bool framing_error = false;  // no stop bit
  bool is_break = false;       // low from the start bit to the stop bit; then neither of the others is set
  Cycles start{};              // of its falling edge
  Cycles end{};                // middle of the stop bit
};

class LineReceiver {
 public:
  explicit LineReceiver(const SerialFormat& format) : format_{format} {}

  // The line changes to `level`, another one than before, at `now`. It has been high before the first call.
  void on_level(Cycles now, bool level);

  // The cycle in which the character under way is complete; none when there is none.
  [[nodiscard]] std::optional<Cycles> next_event() const;
  void advance(Cycles now);

  // The character that the last call of the two above has completed; to be taken before the next call.
  std::optional<ReceivedCharacter> take() { return std::exchange(complete_, std::nullopt); }

 private:
  [[nodiscard]] Cycles middle_of(int bit) const;
  void sample_before(Cycles limit);  // the bits whose middle is before it
  void sample();
  void finish();

  SerialFormat format_;
  bool active_ = false;  // a character is under way
  bool level_ = true;
  Cycles start_{};
  int bit_ = 0;  // next to sample, 0 is the start bit
  unsigned data_ = 0;
  bool parity_ = false;
  std::optional<ReceivedCharacter> complete_;
};

}  // namespace armature::cosim
