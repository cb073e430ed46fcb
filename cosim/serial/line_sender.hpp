// Drives a serial line from a queue of characters, breaks and gaps. A character may have defects.
//
// Queued characters follow each other without a pause. An edge is on the first cycle at or after its exact time
// (line_time.hpp). If the line is idle, a character begins on the cycle in which it is pushed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "controller/base/units.hpp"
#include "cosim/serial/line_time.hpp"
#include "cosim/serial/serial_format.hpp"

namespace armature::cosim {

struct LineItem {
  enum class Kind : std::uint8_t {
    kCharacter,
    kBreak,  // the line is low for `duration`, then high for a bit, so that the next start bit has an edge
    kGap,    // the line is high for `duration`
  };
  Kind kind = Kind::kCharacter;
  std::uint8_t data = 0;            // kCharacter; bits above the format's are dropped
  std::int32_t baud_error_ppm = 0;  // kCharacter: its rate is baud * (1 + this / 1e6)
  bool wrong_parity = false;        // kCharacter: the parity bit is inverted, if there is one
  bool no_stop = false;  // kCharacter: low in the stop time (framing error), then high for a bit. A receiver detects a
                         // character of zeros as a break
  Cycles duration{};     // kBreak, kGap
};

class LineSender {
 public:
  explicit LineSender(const SerialFormat& format) : format_{format} {}

  // Appends an item to the queue.
  void push(const LineItem& item, Cycles now) { queue_.push_back({item, now}); }

  // The cycle at which advance() must be called next; none when there is nothing more to send.
  [[nodiscard]] std::optional<Cycles> next_event() const;

  // Advances the line to `now`. pop_started() reports the items that begin.
  void advance(Cycles now);

  // Level of the line from the cycle of the last advance() on.
  [[nodiscard]] bool level() const { return level_; }

  // Number of items that have not begun.
  [[nodiscard]] std::size_t waiting() const { return queue_.size(); }

  struct Started {
    LineItem item;
    Cycles at{};  // first edge
  };
  // Removes and returns the next item that has begun, in order.
  std::optional<Started> pop_started();

 private:
  struct Waiting {
    LineItem item;
    Cycles pushed_at{};
  };
  // A time of constant level: half_bits plus cycles.
  struct Segment {
    bool level = true;
    int half_bits = 0;
    Cycles cycles{};
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
