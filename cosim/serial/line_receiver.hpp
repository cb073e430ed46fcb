// Receives the characters of a serial line as a UART does. A falling edge of the idle line begins a character. Every
// bit is sampled in its middle, counted from that edge. A start bit that is high in its middle is ignored.
//
// Only the first stop bit is checked. From its middle on the receiver accepts the next falling edge. After a missing
// stop bit the line must go high before that edge.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "controller/base/units.hpp"
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

  // The line changes to `level` at `now`; the level before was the other one. Before the first call the line is high.
  void on_level(Cycles now, bool level);

  // The cycle in which the character under way is complete; none when no character is under way.
  [[nodiscard]] std::optional<Cycles> next_event() const;
  void advance(Cycles now);

  // Removes and returns the character that the last call of on_level() or advance() completed. Call it before the next
  // of these calls.
  std::optional<ReceivedCharacter> pop() { return std::exchange(complete_, std::nullopt); }

 private:
  [[nodiscard]] Cycles middle_of(int bit) const;
  void sample_before(Cycles limit);  // all bits whose middle is before `limit`
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
