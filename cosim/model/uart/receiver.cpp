#include "cosim/model/uart/receiver.hpp"

namespace armature::cosim::model {

bool Receiver::edge(Cycles at, const Orders& orders) {
  bool reported = false;
  bool started = false;
  if (is_running()) ticks_ = (ticks_ + clock_.pass(at, orders.divisor)) % kBitTicks;
  if (is_running()) {
    if (clock_.tick(at, orders.divisor)) sample(orders.line);
  } else if (state_ == State::kIdle) {
    started = !orders.line && orders.divisor != 0;
    if (started) start(orders.format);
  } else if (state_ == State::kDeliver) {
    reported = !orders.hold;
    if (reported) state_ = character_.framing_error ? State::kAwaitHigh : State::kIdle;
  } else if (orders.line) {
    state_ = State::kIdle;
  }
  if (started || orders.new_divisor) clock_.restart(at, orders.divisor);
  return reported;
}

Cycles Receiver::wakes_at(Cycles at, const Orders& next) const {
  const Cycles at_once = at + Cycles{1};
  switch (state_) {
    case State::kAwaitHigh:
      return next.line ? at_once : kNever;
    case State::kIdle:
      return !next.line && next.divisor != 0 ? at_once : kNever;
    case State::kDeliver:
      return next.hold ? kNever : at_once;
    default: {
      const std::int64_t skipped =
          ticks_ <= kMiddle ? (ticks_ < kFirstSample ? kFirstSample - ticks_ : 0) : kBitTicks - ticks_ + kFirstSample;
      return clock_.after(skipped, next.divisor);
    }
  }
}

void Receiver::start(const LineFormat& format) {
  state_ = State::kStart;
  format_ = format;
  bits_left_ = format.bits();
  bits_ = 0;
  position_ = 0;
  ticks_ = 0;
}

void Receiver::sample(bool line) {
  const std::int64_t tick = ticks_;
  ticks_ = (ticks_ + 1) % kBitTicks;
  if (tick == kFirstSample) ones_ = 0;
  if (tick >= kFirstSample && tick <= kMiddle) ones_ += line ? 1 : 0;
  if (tick == kMiddle) take_bit(ones_ >= 2);
}

void Receiver::take_bit(bool level) {
  if (state_ == State::kStart) {
    state_ = level ? State::kIdle : State::kBits;
  } else if (state_ == State::kBits) {
    bits_ |= (level ? 1u : 0u) << position_++;
    if (--bits_left_ == 0) state_ = State::kStop;
  } else {
    assemble(level);
    state_ = State::kDeliver;
  }
}

void Receiver::assemble(bool stop) {
  const std::uint32_t data = bits_ & format_.data_mask();
  const bool parity = (bits_ >> format_.data_bits & 1u) != 0;
  character_.data = static_cast<std::uint8_t>(data);
  character_.framing_error = !stop;
  character_.is_break = !stop && bits_ == 0;
  character_.parity_error = format_.parity && !character_.is_break && parity != format_.parity_of(data);
}

}  // namespace armature::cosim::model
