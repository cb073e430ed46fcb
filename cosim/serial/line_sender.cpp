#include "cosim/serial/line_sender.hpp"

#include <algorithm>

namespace armature::cosim {

std::optional<Cycles> LineSender::next_event() const {
  const Cycles edge = next_edge_.first_cycle();
  if (next_segment_ < segment_count_) return edge;
  if (queue_.empty()) return std::nullopt;
  return std::max(edge, queue_.front().pushed_at);
}

void LineSender::advance(Cycles now) {
  for (auto at = next_event(); at && *at <= now; at = next_event()) {
    if (next_segment_ == segment_count_) {
      begin(queue_.front().item, *at);
      queue_.pop_front();
    }
    const Segment& segment = segments_[next_segment_++];
    level_ = segment.level;
    next_edge_.advance_half_bits(segment.half_bits);
    next_edge_.advance(segment.cycles);
  }
}

std::optional<LineSender::Started> LineSender::pop_started() {
  if (started_.empty()) return std::nullopt;
  const Started first = started_.front();
  started_.pop_front();
  return first;
}

void LineSender::begin(const LineItem& item, Cycles at) {
  // Without a pause a character begins at the exact end of the one before, not at the cycle to which that end is
  // rounded.
  if (at > next_edge_.first_cycle()) next_edge_.set(at);
  next_edge_.set_rate(format_.baud, item.kind == LineItem::Kind::kCharacter ? item.baud_error_ppm : 0);
  segment_count_ = next_segment_ = 0;
  switch (item.kind) {
    case LineItem::Kind::kCharacter:
      add_character(item);
      break;
    case LineItem::Kind::kBreak:
      segments_[segment_count_++] = {.level = false, .half_bits = 0, .cycles = item.duration};
      add_bits(true, 2);
      break;
    case LineItem::Kind::kGap:
      segments_[segment_count_++] = {.level = true, .half_bits = 0, .cycles = item.duration};
      break;
  }
  started_.push_back({item, at});
}

void LineSender::add_character(const LineItem& item) {
  add_bits(false, 2);
  for (int bit = 0; bit < format_.data_bits; ++bit) add_bits((item.data >> bit & 1) != 0, 2);
  if (format_.has_parity()) add_bits(format_.parity_bit(item.data) != item.wrong_parity, 2);
  add_bits(!item.no_stop, format_.stop_half_bits);
  if (item.no_stop) add_bits(true, 2);
}

// Consecutive bits of one level become one segment, so that every event is an edge.
void LineSender::add_bits(bool level, int half_bits) {
  if (segment_count_ > 0 && segments_[segment_count_ - 1].level == level) {
    segments_[segment_count_ - 1].half_bits += half_bits;
  } else {
    segments_[segment_count_++] = {.level = level, .half_bits = half_bits, .cycles = Cycles{}};
  }
}

}  // namespace armature::cosim
