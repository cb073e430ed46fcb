#include "cosim/model/encoder/encoder.hpp"

#include <algorithm>
#include <type_traits>

#include "controller/regs/encoder_regs.hpp"
#include "cosim/logic/axis_bits.hpp"
#include "cosim/model/encoder/encoder_ticks.hpp"

namespace armature::cosim::model {
namespace encoder_regs = armature::regs::encoder;
namespace {

constexpr Cycles kSynchroniserFills{2};

void add_saturating(std::uint16_t& counter, std::uint32_t more) {
  counter = static_cast<std::uint16_t>(std::min<std::uint32_t>(counter + more, 0xFFFF));
}

}  // namespace

template <std::size_t kDecoders>
Encoder<kDecoders>::Encoder() {
  counts_per_rev_.fill(encoder_regs::kCountsPerRevValueReset);
}

template <std::size_t kDecoders>
Answer Encoder<kDecoders>::edge(Cycles at, const Strobes& access, const EncoderInputs& in) {
  Answer answer;
  if (gated_clock_stopped_) {
    wakes_at_ = kNever;
    return answer;
  }
  if (access.read) answer = read(word_offset(access.raddr));
  const auto time = static_cast<std::uint32_t>(at.value() - 1);

  Flagged flagged;
  if (lines_act_) {
    flagged = move(at, lines(in), in.trigger);
  } else if (in.trigger) {
    std::copy_n(expected_.begin(), kDecoders, positions_.begin());
    trigger_time_ = time;
  }
  cleared_faults_ = 0;
  if (access.write) answer.werr = write(access, in.servo_on != 0 && !unlocked_);
  set_faults(flagged.illegal, flagged.index, cleared_faults_, time);
  wakes_at_ = lines_act_ ? lines_wake(at, lines(in)) : kNever;
  return answer;
}

// Everything follows from the state before the edge, so the later stages come first. `levels`: of the lines before it.
template <std::size_t kDecoders>
typename Encoder<kDecoders>::Flagged Encoder<kDecoders>::move(Cycles at, typename Filter::Word levels, bool trigger) {
  const auto time = static_cast<std::uint32_t>(at.value() - 1);
  const Steps steps = this->steps();
  const std::uint32_t mismatch = std::exchange(mismatch_, latch_index(steps));
  if (trigger) snapshot(time);
  count_errors(steps.illegal);
  count(steps, time);
  index_ = z() & ~z_before_ & filter_.known() >> 2 * kDecoders;
  a_before_ = a();
  b_before_ = b();
  z_before_ = z();
  const auto samples = pins_.ago(2);
  if (at > kSynchroniserFills) {
    filter_.edge(at, samples, filter_settings());
  } else {
    filter_.follow(samples);
  }
  pins_.sample(levels);
  sampled_ = samples;
  return {.illegal = steps.illegal, .index = mismatch};
}

// The next edge after `at`, the latest one, while the lines keep their levels.
template <std::size_t kDecoders>
Cycles Encoder<kDecoders>::lines_wake(Cycles at, typename Filter::Word levels) const {
  const bool due =
      has_pending_events() || sampled_ != pins_.ago(2) || !pins_.are_settled(levels) || at <= kSynchroniserFills;
  return due ? at + Cycles{1} : filter_.wakes_at(at, filter_settings());
}

template <std::size_t kDecoders>
bool Encoder<kDecoders>::has_pending_events() const {
  return a() != a_before_ || b() != b_before_ || z() != z_before_ || index_ != 0 || mismatch_ != 0;
}

// Vo 2021, Table 1: a transition counts up if the new level of A differs from the old one of B.
template <std::size_t kDecoders>
typename Encoder<kDecoders>::Steps Encoder<kDecoders>::steps() const {
  const std::uint32_t a_edges = (a() ^ a_before_) & known();
  const std::uint32_t b_edges = (b() ^ b_before_) & known();
  const std::uint32_t one = a_edges ^ b_edges;
  const std::uint32_t up = one & (a() ^ b_before_);
  return {.up = up, .down = one & ~up, .illegal = a_edges & b_edges};
}

template <std::size_t kDecoders>
void Encoder<kDecoders>::snapshot(std::uint32_t time) {
  for (std::size_t i = 0; i < kDecoders; ++i) {
    positions_[i] = axes_[i].position;
    edge_times_[i] = axes_[i].counted_at;
  }
  trigger_time_ = time;
}

template <std::size_t kDecoders>
void Encoder<kDecoders>::count_errors(std::uint32_t illegal) {
  for_each_bit(illegal, [this](std::size_t axis) { add_saturating(axes_[axis].illegal, 1); });
  for_each_bit(filter_.glitches(), [this](std::size_t line) { add_saturating(axes_[line % kDecoders].glitches, 1); });
}

template <std::size_t kDecoders>
void Encoder<kDecoders>::count(const Steps& steps, std::uint32_t time) {
  for_each_bit(steps.up | steps.down, [&](std::size_t axis) {
    axes_[axis].position += has_bit(steps.up, axis) ? 1u : ~0u;
    axes_[axis].counted_at = time;
  });
}

// Axes whose next index is checked, one bit each.
template <std::size_t kDecoders>
std::uint32_t Encoder<kDecoders>::checked_indexes() const {
  using armature::regs::extract;
  const std::uint32_t first = extract(index_check_, encoder_regs::kIndexCheckFirst);
  return extract(index_check_, encoder_regs::kIndexCheckEnable) & (seen_ | first);
}

// Two successive positions are equal or one revolution apart. Before the first one there is 0.
template <std::size_t kDecoders>
bool Encoder<kDecoders>::fits_index(std::size_t axis, std::uint32_t position) const {
  const std::uint32_t moved = position - axes_[axis].index_position, turn = counts_per_rev_[axis];
  return moved == 0 || moved == turn || moved == 0u - turn;
}

template <std::size_t kDecoders>
std::uint32_t Encoder<kDecoders>::latch_index(const Steps& steps) {
  std::uint32_t mismatch = 0;
  for_each_bit(index_, [&](std::size_t i) {
    const std::uint32_t step = (steps.up >> i & 1u) - (steps.down >> i & 1u);
    const std::uint32_t position = axes_[i].position + step;
    if (!fits_index(i, position)) mismatch |= 1u << i;
    axes_[i].index_position = position;
  });
  mismatch &= checked_indexes();
  seen_ |= index_;
  return mismatch;
}

template <std::size_t kDecoders>
void Encoder<kDecoders>::set_faults(std::uint32_t illegal, std::uint32_t index, std::uint32_t cleared,
                                    std::uint32_t time) {
  if (illegal != 0 && (faults_ & encoder_regs::kFaultIllegalMask) == 0) fault_times_[0] = time;
  if (index != 0 && (faults_ & encoder_regs::kFaultIndexMask) == 0) fault_times_[1] = time;
  faults_ = (faults_ & ~cleared) | armature::regs::insert(0, encoder_regs::kFaultIllegal, illegal) |
            armature::regs::insert(0, encoder_regs::kFaultIndex, index);
}

template <std::size_t kDecoders>
Answer Encoder<kDecoders>::read(std::uint32_t offset) const {
  using armature::regs::insert;
  // What an axis without a decoder measures is 0.
  const auto of = [](const auto& decoders, std::size_t axis) {
    return axis < kDecoders ? decoders[axis] : typename std::remove_cvref_t<decltype(decoders)>::value_type{};
  };
  if (const auto i = element_at(offset, encoder_regs::kPositionOffset)) return {.rdata = of(positions_, *i)};
  if (const auto i = element_at(offset, encoder_regs::kEdgeTimeOffset)) return {.rdata = of(edge_times_, *i)};
  if (const auto i = element_at(offset, encoder_regs::kIndexPositionOffset))
    return {.rdata = of(axes_, *i).index_position};
  if (const auto i = element_at(offset, encoder_regs::kCountsPerRevOffset)) return {.rdata = counts_per_rev_[*i]};
  if (const auto i = element_at(offset, encoder_regs::kIllegalCountOffset)) return {.rdata = of(axes_, *i).illegal};
  if (const auto i = element_at(offset, encoder_regs::kGlitchCountOffset)) return {.rdata = of(axes_, *i).glitches};
  switch (offset) {
    case encoder_regs::kIdOffset:
      return {.rdata = insert(encoder_regs::kIdWord, encoder_regs::kIdAxes, kDecoders)};
    case encoder_regs::kDebounceOffset:
      return {.rdata = debounce_};
    case encoder_regs::kIndexCheckOffset:
      return {.rdata = index_check_};
    case encoder_regs::kFilterOffset:
      return {.rdata = up_down_};
    case encoder_regs::kFaultOffset:
      return {.rdata = faults_};
    case encoder_regs::kTriggerTimeOffset:
      return {.rdata = trigger_time_};
    case encoder_regs::kIndexSeenOffset:
      return {.rdata = seen_};
    case encoder_regs::kKnownOffset:
      return {.rdata = known()};
    case encoder_regs::kKeyOffset:
      return {.rdata = unlocked_};
    case encoder_regs::kFaultTimeOffset:
    case encoder_regs::kFaultTimeOffset + encoder_regs::kFaultTimeStride:
      return {.rdata = fault_times_[(offset - encoder_regs::kFaultTimeOffset) / 4]};
    default:
      return kUnmappedRead;
  }
}

template <std::size_t kDecoders>
bool Encoder<kDecoders>::write(const Strobes& access, bool locked) {
  const std::uint32_t offset = word_offset(access.waddr);
  if (const auto axis = element_at(offset, encoder_regs::kCountsPerRevOffset)) {
    std::uint32_t& counts = counts_per_rev_[*axis];
    counts = merged(counts, access) & encoder_regs::kCountsPerRevValueMask;
    return false;
  }
  switch (offset) {
    case encoder_regs::kDebounceOffset:
      if (!locked) debounce_ = static_cast<std::uint8_t>(merged(debounce_, access));
      return locked;
    case encoder_regs::kIndexCheckOffset:
      index_check_ =
          merged(index_check_, access) & (encoder_regs::kIndexCheckEnableMask | encoder_regs::kIndexCheckFirstMask);
      return false;
    case encoder_regs::kFilterOffset:
      if (!locked) up_down_ = (merged(up_down_, access) & encoder_regs::kFilterModeMask) != 0;
      return locked;
    case encoder_regs::kFaultOffset:
      cleared_faults_ = merged(0, access);
      return false;
    case encoder_regs::kKeyOffset:
      unlocked_ = access.wstrb == 0xF && access.wdata == encoder_regs::kKeyWord;
      return false;
    default:
      return true;
  }
}

template class Encoder<1>;
template class Encoder<6>;

}  // namespace armature::cosim::model
