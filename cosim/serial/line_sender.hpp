// Drives a serial line with a queue of characters, each with the defects that it is to have, breaks and gaps.
//
// Characters that wait follow each other without a pause. An edge is on the first cycle at or after its exact moment
// (line_time.hpp); a character that finds the line idle begins on the cycle in which it is pushed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "controller/core/units.hpp"
#include "cosim/serial/line_time.hpp"
#include "cosim/serial/serial_format.hpp"

namespace armature::cosim {

struct LineItem {
  enum class Kind : std::uint8_t {
    kCharacter,
    kBreak,  // the line is low for `duration`, then high for a bit, so that a next start bit has an edge
    kGap,    // the line is high for `duration`
  };
  Kind kind = Kind::kCharacter;
  std::uint8_t data = 0;            // kCharacter; bits above the format's are dropped
  std::int32_t baud_error_ppm = 0;  // kCharacter: its rate is baud * (1 + this / 1e6)
  bool wrong_parity = false;        // kCharacter: the parity bit is inverted, if there is one
  bool no_stop = false;  // kCharacter: low in the stop time (framing error), then high for a bit. One of zeros is a
                         // break to any receiver
  Cycles duration{};     // kBreak, kGap
};

class LineSender {
 public:
  explicit LineSender(const SerialFormat& format) : format_{format} {}

  // Adds an item behind the others.
  void push(const LineItem& item, Cycles now) { queue_.push_back({item, now}); }

  // The cycle at which advance() must be called next; none when everything is on the line.
  [[nodiscard]] std::optional<Cycles> next_event() const;

  // Brings the line to `now`. An item that begins is reported by take_started().
  void advance(Cycles now);

  // What the line is from the cycle of the last advance() on.
  [[nodiscard]] bool level() const { return level_; }

  // Items that have not begun.
  [[nodiscard]] std::size_t waiting() const { return queue_.size(); }

  struct Started {
    LineItem item;
    Cycles at{};  // first edge
  };
  // Items that have begun, each once, in their order.
  std::optional<Started> take_started();

 private:
  struct Waiting {
    LineItem item;
    Cycles pushed_at{};
  };
  // A stretch of one level.
  struct Segment {
    bool level = true;
    int half_bits = 0;
    Cycles cycles{};  // in addition
  };
  void begin(const LineItem& item, Cycles at);
  void add_character(const LineItem& item);
  void add_bits(bool level, int half_bits);

  SerialFormat format_;
  std::deque<Waiting> queue_;
  std::deque<Started> started_;
  std::array<Segment, 12> segments_{};  // of the item under way
  std::size_t segment_count_ = 0;
  std::size_t next_segment_ = 0;
  LineTime next_edge_;  // beginning of segments_[next_segment_], or the end of the item
  bool level_ = true;
};

}  // namespace armature::cosim
