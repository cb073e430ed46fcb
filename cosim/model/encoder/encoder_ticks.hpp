// Whole ticks of the encoder: what its lines would have done at the edges that were left out. Only encoder.cpp includes
// these definitions, and instantiates the whole class once.
#pragma once

#include <algorithm>

#include "controller/regs/encoder_regs.hpp"
#include "cosim/model/encoder/encoder.hpp"

namespace armature::cosim::model {

constexpr std::uint32_t as_register(Counts counts) {
  return static_cast<std::uint32_t>(counts.value());
}

template <std::size_t kDecoders>
bool Encoder<kDecoders>::leave_out_lines(Cycles at, const LineHistory& history) {
  if (gated_clock_stopped_) return false;
  for (const auto& change : history.changes) {
    if (change.lines.z != history.lines.z) return false;
  }
  Encoder replayed = *this;
  replayed.offsets_.fill(0);
  replayed.replay(history, at);
  const bool equal = pins_ == replayed.pins_ && filter_.equals(replayed.filter_, at) &&
                     a_before_ == replayed.a_before_ && b_before_ == replayed.b_before_ &&
                     z_before_ == replayed.z_before_ && index_ == replayed.index_ && mismatch_ == replayed.mismatch_;
  if (!equal) return false;
  for (std::size_t i = 0; i < kDecoders; ++i) offsets_[i] = axes_[i].position - replayed.axes_[i].position;
  lines_act_ = false;
  wakes_at_ = at + Cycles{1};
  return true;
}

template <std::size_t kDecoders>
bool Encoder<kDecoders>::expect(const PerAxis<Counts>& counts, const PerAxis<std::optional<Counts>>& index) {
  for (std::size_t i = 0; i < kDecoders; ++i) {
    if (!index[i] || (checked_indexes() & 1u << i) == 0) continue;
    if (!fits_index(i, as_register(*index[i]) + offsets_[i])) return false;
  }
  for (std::size_t i = 0; i < kDecoders; ++i) {
    expected_[i] = as_register(counts[i]) + offsets_[i];
    if (!index[i]) continue;
    axes_[i].index_position = as_register(*index[i]) + offsets_[i];
    seen_ |= 1u << i;
  }
  return true;
}

template <std::size_t kDecoders>
void Encoder<kDecoders>::continue_after(Cycles at, const LineHistory& history, bool begun) {
  if (begun) {  // what the trigger has copied
    Encoder before = *this;
    before.replay(history, at - Cycles{1});
    for (std::size_t i = 0; i < kDecoders; ++i) edge_times_[i] = before.axes_[i].counted_at;
  }
  replay(history, at);
  lines_act_ = true;
}

// From the edge history.from, before which the lines stood still, to `until`.
template <std::size_t kDecoders>
void Encoder<kDecoders>::replay(const LineHistory& history, Cycles until) {
  EncoderLines levels = history.lines;
  pins_.fill(lines(levels));
  sampled_ = lines(levels);
  filter_.settle(history.from, lines(levels));
  a_before_ = a();
  b_before_ = b();
  z_before_ = z();
  index_ = mismatch_ = 0;
  for (std::size_t i = 0; i < kDecoders; ++i) {
    axes_[i].position = as_register(history.counts[i]) + offsets_[i];
    if (history.counted[i] != Cycles{}) {
      axes_[i].counted_at = static_cast<std::uint32_t>((history.counted[i] + latency() - Cycles{1}).value());
    }
  }
  Cycles at = history.from;
  const auto run = [&](Cycles end) {
    for (Cycles next = lines_wake_at(at, levels); next <= end; next = lines_wake_at(at, levels)) {
      at = next;
      line_edge(at, levels);
    }
    at = end;
  };
  for (const LineHistory::Change& change : history.changes) {
    run(std::min(change.at, until));
    levels = change.lines;
  }
  run(until);
}

template <std::size_t kDecoders>
void Encoder<kDecoders>::line_edge(Cycles at, const EncoderLines& levels) {
  const Flagged flagged = move(at, lines(levels), false);
  set_faults(flagged.illegal, flagged.index, 0, static_cast<std::uint32_t>(at.value() - 1));
}

template <std::size_t kDecoders>
bool Encoder<kDecoders>::write_disturbs(std::uint32_t offset) {
  return offset != armature::regs::encoder::kFaultOffset && offset != armature::regs::encoder::kKeyOffset;
}

template <std::size_t kDecoders>
bool Encoder<kDecoders>::read_disturbs(std::uint32_t offset) {
  namespace encoder_regs = armature::regs::encoder;
  return !element_at(offset, encoder_regs::kPositionOffset) && offset != encoder_regs::kFaultOffset &&
         offset != encoder_regs::kIdOffset && offset != encoder_regs::kKnownOffset;
}

}  // namespace armature::cosim::model
