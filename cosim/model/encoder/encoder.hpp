// Model of the block encoder: quadrature decoders with debounce, snapshots, index check and error counters. Written
// from rtl/REGISTERS.md and rtl/encoder/README.md.
//
// A pin acts through two flops of the synchroniser and the filter. The position changes one edge after the filter
// accepts a level. An index latches the position two edges after its level. Edge `at` has the time at - 1.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/regs/encoder_regs.hpp"
#include "cosim/logic/whole_tick.hpp"
#include "cosim/model/block.hpp"
#include "cosim/model/encoder/line_filter.hpp"
#include "cosim/model/pin_samples.hpp"

namespace armature::cosim::model {

// Levels before an edge. One bit per axis, axis 1 is bit 0.
struct EncoderInputs {
  std::uint8_t a = 0, b = 0, z = 0;
  std::uint8_t servo_on = 0;  // enables of the drives; while one is 1, DEBOUNCE and FILTER are protected
  bool trigger = false;

  friend bool operator==(const EncoderInputs&, const EncoderInputs&) = default;
};

// kDecoders: 6, or 1 behind the encoder switch. Registers of axes without a decoder exist; what they measure is 0.
template <std::size_t kDecoders>
class Encoder {
 public:
  Answer edge(Cycles at, const Strobes& access, const EncoderInputs& in);
  Answer access(Cycles at, const Strobes& access, const EncoderInputs& in) {
    return access.write || gated_clock_stopped_ ? edge(at, access, in) : read(word_offset(access.raddr));
  }
  [[nodiscard]] Cycles wakes_at() const { return wakes_at_; }
  // A read of what lines do not change between two triggers.
  [[nodiscard]] std::optional<std::uint32_t> peek(std::uint32_t offset) const {
    if (const auto i = element_at(offset, armature::regs::encoder::kPositionOffset); i && *i < kDecoders) {
      return positions_[*i];
    }
    if (offset == armature::regs::encoder::kFaultOffset) return faults_;
    return std::nullopt;
  }

  // ---- whole ticks: the edges at which only the lines act are left out

  // Cycles from a change of the lines to the position that the edge after a trigger copies: with a trigger after the
  // edge T, that of T minus this. Changes of the lines of an axis must be further apart than this.
  [[nodiscard]] Cycles latency() const { return kPath + filter_time(); }
  // Number of edges of LineHistory that continue_after() needs.
  [[nodiscard]] Cycles history() const { return latency() + kPath + Cycles{1}; }

  // Leaves them out from the latest edge `at` on. Returns whether that is possible: whether the state follows from the
  // lines, without a glitch or an index on its way.
  [[nodiscard]] bool leave_out_lines(Cycles at, const LineHistory& history);
  // What the coming trigger copies: the encoders have shown `counts`. `index`: the count at which an index has come in
  // the tick. Returns whether all indexes fit; if not, nothing has changed.
  [[nodiscard]] bool expect(const PerAxis<Counts>& counts, const PerAxis<std::optional<Counts>>& index);
  // Computes the lines again, after the latest edge `at`. `begun`: it has seen a trigger.
  void continue_after(Cycles at, const LineHistory& history, bool begun);
  // An edge of the lines that was left out, with their levels before it; and the next one.
  void line_edge(Cycles at, const EncoderLines& lines);
  [[nodiscard]] Cycles lines_wake_at(Cycles at, const EncoderLines& levels) const {
    return lines_wake(at, lines(levels));
  }
  [[nodiscard]] static bool write_disturbs(std::uint32_t offset);
  [[nodiscard]] static bool read_disturbs(std::uint32_t offset);

  // The edge after `now` must be computed: edges before it were computed late.
  void wake_after(Cycles now) { wakes_at_ = now + Cycles{1}; }

  // The clock of everything but TIME and synchroniser stands still from now on: nothing of the block is visible any
  // more.
  void stop_gated_clock() { gated_clock_stopped_ = true; }

 private:
  static constexpr std::size_t kLines = 3 * kDecoders;
  static constexpr std::uint32_t kMask = (1u << kDecoders) - 1;
  using Filter = LineFilter<kLines>;
  static constexpr Cycles kPath{3};  // two flops of the synchroniser, and the position

  // One decoder.
  struct Axis {
    std::uint32_t position = 0;
    std::uint32_t counted_at = 0;  // time of the last count
    std::uint32_t index_position = 0;
    std::uint16_t illegal = 0, glitches = 0;  // saturating
  };
  // Events of single edges, one bit per axis.
  struct Steps {
    std::uint32_t up = 0, down = 0, illegal = 0;
  };

  [[nodiscard]] std::uint32_t a() const { return filter_.level() & kMask; }
  [[nodiscard]] std::uint32_t b() const { return filter_.level() >> kDecoders & kMask; }
  [[nodiscard]] std::uint32_t z() const { return filter_.level() >> 2 * kDecoders & kMask; }
  [[nodiscard]] std::uint32_t known() const { return filter_.known() & filter_.known() >> kDecoders & kMask; }
  template <class Levels>
  [[nodiscard]] static typename Filter::Word lines(const Levels& in) {
    return (in.a & kMask) | (in.b & kMask) << kDecoders | (in.z & kMask) << 2 * kDecoders;
  }
  [[nodiscard]] Cycles filter_time() const { return Cycles{std::max<std::int64_t>(debounce_, 1)}; }
  [[nodiscard]] typename Filter::Settings filter_settings() const { return {.time = debounce_, .up_down = up_down_}; }
  [[nodiscard]] bool has_pending_events() const;
  // Axes whose events set a flag.
  struct Flagged {
    std::uint32_t illegal = 0, index = 0;
  };
  Flagged move(Cycles at, typename Filter::Word levels, bool trigger);
  [[nodiscard]] Cycles lines_wake(Cycles at, typename Filter::Word levels) const;
  void replay(const LineHistory& history, Cycles until);

  [[nodiscard]] Steps steps() const;
  void snapshot(std::uint32_t time);
  void count_errors(std::uint32_t illegal);
  [[nodiscard]] std::uint32_t checked_indexes() const;
  [[nodiscard]] bool fits_index(std::size_t axis, std::uint32_t position) const;
  [[nodiscard]] std::uint32_t latch_index(const Steps& steps);  // returns the axes with a mismatch
  void count(const Steps& steps, std::uint32_t time);
  void set_faults(std::uint32_t illegal, std::uint32_t index, std::uint32_t cleared, std::uint32_t time);
  [[nodiscard]] Answer read(std::uint32_t offset) const;
  [[nodiscard]] bool write(const Strobes& access, bool locked);  // returns whether it is refused

  PinSamples<typename Filter::Word, 2> pins_;
  typename Filter::Word sampled_ = 0;  // what the filter has seen at the latest edge
  Filter filter_;
  std::array<Axis, kDecoders> axes_{};
  std::uint32_t a_before_ = 0, b_before_ = 0, z_before_ = 0;  // levels that the decoders have seen
  std::uint32_t index_ = 0;                                   // axes whose index rose at the edge before
  std::uint32_t mismatch_ = 0;                                // axes whose index did not fit at the edge before
  std::uint32_t seen_ = 0;                                    // axes with an index since reset

  // Snapshots of the last trigger.
  std::array<std::uint32_t, kDecoders> positions_{}, edge_times_{};
  std::uint32_t trigger_time_ = 0;

  // Registers.
  std::uint8_t debounce_ = 5;
  bool up_down_ = false;
  bool unlocked_ = false;
  std::uint32_t index_check_ = 0;
  std::uint32_t faults_ = 0;
  std::array<std::uint32_t, 2> fault_times_{};  // of illegal transitions, of the index
  PerAxis<std::uint32_t> counts_per_rev_;
  std::uint32_t cleared_faults_ = 0;  // by the write of this edge

  // While the lines are left out.
  bool lines_act_ = true;
  PerAxis<std::uint32_t> offsets_{};   // position minus count of the encoder
  PerAxis<std::uint32_t> expected_{};  // positions

  Cycles wakes_at_ = Cycles{1};
  bool gated_clock_stopped_ = false;

 public:
  Encoder();
};

extern template class Encoder<1>;
extern template class Encoder<6>;

}  // namespace armature::cosim::model
