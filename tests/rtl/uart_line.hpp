// The far end of a serial line, bit by bit, independent of the receiver and transmitter under test: a sender with any
// bit time and every kind of error, and a receiver that samples in the middle of each bit.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <deque>
#include <ostream>
#include <string>
#include <vector>

namespace armature::test {

enum class UartParity { kNone, kOdd, kEven, kMark, kSpace };
inline constexpr UartParity kAllParities[] = {UartParity::kNone, UartParity::kOdd, UartParity::kEven, UartParity::kMark,
                                              UartParity::kSpace};

struct UartFormat {
  unsigned data_bits = 8;  // 5 to 8
  UartParity parity = UartParity::kNone;
  bool long_stop = false;  // two stop bits, or one and a half after five data bits

  [[nodiscard]] std::uint32_t lcr() const {
    static constexpr std::uint32_t kParityBits[] = {0x00, 0x08, 0x18, 0x28, 0x38};
    return (data_bits - 5) | (long_stop ? 4u : 0u) | kParityBits[static_cast<int>(parity)];
  }
  [[nodiscard]] bool has_parity() const { return parity != UartParity::kNone; }
  [[nodiscard]] unsigned mask() const { return (1u << data_bits) - 1; }
  [[nodiscard]] bool parity_bit(unsigned data) const {
    const bool odd_ones = std::popcount(data & mask()) % 2 == 1;
    switch (parity) {
      case UartParity::kOdd:
        return !odd_ones;
      case UartParity::kEven:
        return odd_ones;
      case UartParity::kMark:
        return true;
      default:
        return false;
    }
  }
  [[nodiscard]] double stop_bits() const { return !long_stop ? 1 : data_bits == 5 ? 1.5 : 2; }
  [[nodiscard]] double bits() const { return 1 + data_bits + (has_parity() ? 1 : 0) + stop_bits(); }  // per character

  friend std::ostream& operator<<(std::ostream& out, const UartFormat& f) {
    return out << f.data_bits << "NOEMS"[static_cast<int>(f.parity)] << f.stop_bits();
  }
};

inline std::vector<UartFormat> all_uart_formats() {
  std::vector<UartFormat> formats;
  for (const unsigned bits : {5u, 6u, 7u, 8u}) {
    for (const UartParity parity : kAllParities) {
      for (const bool long_stop : {false, true}) formats.push_back({bits, parity, long_stop});
    }
  }
  return formats;
}

// A run of equal levels.
struct LineSegment {
  bool level;
  std::int64_t clocks;
  friend bool operator==(const LineSegment&, const LineSegment&) = default;
  friend std::ostream& operator<<(std::ostream& out, const LineSegment& s) {
    return out << (s.level ? "high " : "low ") << s.clocks;
  }
};

class LineSender {
 public:
  double bit_clocks = 16;

  // Queues a level. The line is high while the queue is empty.
  void level(bool value, double clocks) {
    end_ = (queue_.empty() ? static_cast<double>(now_) : end_) + clocks;
    queue_.push_back({value, end_});
  }
  void bits(bool value, double count) { level(value, count * bit_clocks); }
  void send(unsigned data, const UartFormat& format, bool wrong_parity = false, bool stop = true) {
    bits(false, 1);
    for (unsigned i = 0; i < format.data_bits; ++i) bits(data >> i & 1u, 1);
    if (format.has_parity()) bits(format.parity_bit(data) != wrong_parity, 1);
    bits(stop, format.stop_bits());
  }

  [[nodiscard]] bool idle() const { return queue_.empty(); }

  // Returns the level of the coming clock.
  bool clock() {
    while (!queue_.empty() && static_cast<double>(now_) >= queue_.front().end) queue_.pop_front();
    ++now_;
    return queue_.empty() || queue_.front().level;
  }

 private:
  struct Run {
    bool level;
    double end;  // clocks since the beginning
  };
  std::deque<Run> queue_;
  double end_ = 0;
  std::int64_t now_ = 0;
};

struct LineCharacter {
  unsigned data = 0;
  bool parity = false;
  bool stop = false;
  std::int64_t start = 0;  // clock of the falling edge
};

class LineReceiver {
 public:
  double bit_clocks = 16;
  UartFormat format;

  std::vector<LineCharacter> characters;
  std::vector<LineSegment> segments;  // the last one has not ended yet

  void clock(bool level) {
    if (segments.empty() || segments.back().level != level) {
      if (!active_ && !level && !segments.empty()) begin();
      segments.push_back({level, 0});
    }
    ++segments.back().clocks;
    if (active_ && static_cast<double>(now_ - current_.start) >= (sampled_ + 0.5) * bit_clocks) sample(level);
    ++now_;
  }

  [[nodiscard]] std::vector<unsigned> data() const {
    std::vector<unsigned> values;
    for (const LineCharacter& c : characters) values.push_back(c.data);
    return values;
  }
  [[nodiscard]] std::int64_t now() const { return now_; }

 private:
  void begin() {
    active_ = true;
    sampled_ = 0;
    current_ = {0, false, false, now_};
  }
  void sample(bool level) {
    const unsigned index = sampled_++;
    if (index == 0) return;
    if (index <= format.data_bits) {
      current_.data |= static_cast<unsigned>(level) << (index - 1);
    } else if (format.has_parity() && index == format.data_bits + 1) {
      current_.parity = level;
    } else {
      current_.stop = level;
      characters.push_back(current_);
      active_ = false;
    }
  }

  bool active_ = false;
  unsigned sampled_ = 0;  // bits of current_, with the start bit
  LineCharacter current_;
  std::int64_t now_ = 0;
};

}  // namespace armature::test
