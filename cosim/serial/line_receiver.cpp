#include "cosim/serial/line_receiver.hpp"

#include "controller/base/timebase.hpp"

namespace armature::cosim {

// The level is known between two changes, so only the last sample of a character needs an event.
std::optional<Cycles> LineReceiver::next_event() const {
  if (!active_) return std::nullopt;
  return middle_of(format_.bits_before_stop());
}

void LineReceiver::on_level(Cycles now, bool level) {
  sample_before(now);
  level_ = level;
  if (active_ || level) return;
  active_ = true;
  start_ = now;
  bit_ = 0;
  data_ = 0;
  parity_ = false;
}

void LineReceiver::advance(Cycles now) {
  sample_before(now + Cycles{1});
}

Cycles LineReceiver::middle_of(int bit) const {
  const std::int64_t half_bit = 2 * format_.baud;  // denominator
  return start_ + Cycles{((2 * bit + 1) * kClkFreqHz + half_bit - 1) / half_bit};
}

void LineReceiver::sample_before(Cycles limit) {
  while (active_ && middle_of(bit_) < limit) sample();
}

void LineReceiver::sample() {
  const int bit = bit_++;
  if (bit == 0) {
    active_ = !level_;
  } else if (bit <= format_.data_bits) {
    data_ |= (level_ ? 1u : 0u) << (bit - 1);
  } else if (bit < format_.bits_before_stop()) {
    parity_ = level_;
  } else {
    finish();
  }
}

void LineReceiver::finish() {
  ReceivedCharacter character;
  character.data = static_cast<std::uint8_t>(data_);
  character.is_break = !level_ && data_ == 0 && !parity_;
  character.framing_error = !level_ && !character.is_break;
  character.parity_error = format_.has_parity() && !character.is_break && parity_ != format_.parity_bit(data_);
  character.start = start_;
  character.end = middle_of(format_.bits_before_stop());
  complete_ = character;
  active_ = false;
}

}  // namespace armature::cosim
