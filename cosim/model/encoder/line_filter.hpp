// The debounce filter of up to 32 lines (rtl/encoder/README.md, FILTER.mode): a new level counts from the edge at which
// it has lasted DEBOUNCE.time edges. A shorter one is a glitch.
//
// Each line has a count of samples against its level. It is stored with the edge at which it was right, so that edges
// at which only counts change need not be computed.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "cosim/logic/axis_bits.hpp"
#include "cosim/model/block.hpp"

namespace armature::cosim::model {

template <std::size_t kLines>
class LineFilter {
 public:
  using Word = std::uint32_t;  // one bit per line
  static constexpr Word kAll = kLines == 32 ? ~Word{0} : (Word{1} << kLines) - 1;

  struct Settings {
    std::int64_t time = 5;  // DEBOUNCE.time; 0 acts as 1
    bool up_down = false;   // FILTER.mode
  };

  // The edge `at` with its samples.
  void edge(Cycles at, Word samples, const Settings& settings) {
    glitches_ = 0;
    if (known_ != kAll) learn(at, samples, settings);
    for_each_bit(((samples ^ level_) | counting_) & known_before_,
                 [&](std::size_t line) { step(at, line, samples, settings); });
    known_before_ = known_;
    differs_ = (samples ^ level_) & kAll;
  }
  // While the synchroniser has no samples yet.
  void follow(Word samples) { level_ = samples; }

  // As if the samples had been `samples` for a long time before the edge `at`.
  void settle(Cycles at, Word samples) {
    level_ = samples;
    known_ = known_before_ = kAll;
    differs_ = counting_ = glitches_ = 0;
    counts_.fill({.value = 0, .at = at});
  }
  // Whether both do the same after the edge `at`, the latest one of both.
  [[nodiscard]] bool equals(const LineFilter& other, Cycles at) const {
    const auto count = [at](const LineFilter& filter, std::size_t line) {
      const std::int64_t passed = (at - filter.counts_[line].at).value();
      return filter.counts_[line].value + (has_bit(filter.differs_, line) ? passed : -passed);
    };
    bool equal = level_ == other.level_ && known_ == other.known_ && known_before_ == other.known_before_ &&
                 differs_ == other.differs_ && counting_ == other.counting_ && glitches_ == other.glitches_;
    for_each_bit(counting_, [&](std::size_t line) { equal = equal && count(*this, line) == count(other, line); });
    return equal;
  }

  // The next edge, after the edge `at`, at which a level or a glitch changes while the samples stay as they are.
  [[nodiscard]] Cycles wakes_at(Cycles at, const Settings& settings) const {
    if (known_ != kAll || glitches_ != 0) return at + Cycles{1};
    Cycles wake = kNever;
    for_each_bit((differs_ | counting_) & kAll, [&](std::size_t line) {
      const bool up = has_bit(differs_, line);
      const std::int64_t edges = up ? 1 + std::max<std::int64_t>(last(settings) - counts_[line].value, 0)
                                 : settings.up_down ? counts_[line].value
                                                    : 1;
      wake = std::min(wake, at + Cycles{std::max<std::int64_t>(edges - (at - counts_[line].at).value(), 1)});
    });
    return wake;
  }

  [[nodiscard]] Word level() const { return level_; }
  [[nodiscard]] Word known() const { return known_; }        // lines whose level was accepted since reset
  [[nodiscard]] Word glitches() const { return glitches_; }  // at the latest edge

 private:
  struct Count {
    std::int64_t value = 0;  // after the edge `at`
    Cycles at{};
  };

  // The count of the last sample before a level is accepted.
  [[nodiscard]] static std::int64_t last(const Settings& settings) {
    return std::max<std::int64_t>(settings.time, 1) - 1;
  }

  void step(Cycles at, std::size_t line, Word samples, const Settings& settings) {
    const Word bit = Word{1} << line;
    const std::int64_t passed = (at - counts_[line].at).value() - 1;
    const bool was_counting_up = (differs_ & bit) != 0;
    const std::int64_t before = (counting_ & bit) == 0 ? 0 : counts_[line].value + (was_counting_up ? passed : -passed);
    std::int64_t count = 0;
    if (((samples ^ level_) & bit) != 0) {
      if (before >= last(settings)) {
        level_ ^= bit;
      } else {
        count = before + 1;
      }
    } else if (before > 0) {
      count = settings.up_down ? before - 1 : 0;
      if (count == 0) glitches_ |= bit;
    }
    store(line, count, at);
  }

  // After reset: the first level that lasts is adopted. Computed at every edge.
  void learn(Cycles at, Word samples, const Settings& settings) {
    for_each_bit(~known_ & kAll, [&](std::size_t line) {
      const Word bit = Word{1} << line;
      std::int64_t count = counts_[line].value;
      if (((samples ^ level_) & bit) == 0) {
        const bool accepted = count >= last(settings);
        if (accepted) known_ |= bit;
        count = accepted ? 0 : count + 1;
      } else if (settings.up_down && count > 0) {
        --count;
      } else {
        level_ ^= bit;
        count = 0;
      }
      store(line, count, at);
    });
  }

  void store(std::size_t line, std::int64_t count, Cycles at) {
    const Word bit = Word{1} << line;
    counts_[line] = {.value = count, .at = at};
    counting_ = count != 0 ? counting_ | bit : counting_ & ~bit;
  }

  Word level_ = 0;
  Word known_ = 0;
  Word known_before_ = 0;  // before the edge that is computed
  Word differs_ = 0;       // samples of the latest edge that differ from the level
  Word counting_ = 0;      // counts that are not 0
  Word glitches_ = 0;
  std::array<Count, kLines> counts_{};
};

}  // namespace armature::cosim::model
