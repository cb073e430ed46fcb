// Model of a 16550A for software, between characters: registers, receive FIFO, error bits and interrupt sources. It has
// no time: characters arrive or leave as a whole, and the caller reports when four character times have passed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace armature::test {

class UartModel {
 public:
  struct Character {
    std::uint32_t data;
    std::uint32_t errors;  // PE, FE and BI at their bits in LSR
  };

  void write_ier(std::uint32_t value) {
    if ((value & 2u) != 0 && (ier_ & 2u) == 0) thre_pending_ = true;  // THR is empty between characters
    ier_ = value & 0xFu;
  }
  void write_fcr(std::uint32_t value) {
    const bool on = (value & 1u) != 0, switched = on != fifo_on();
    if (on) {
      fcr_ = value & 0xC9u;
    } else {
      fcr_ &= ~1u;
    }
    if (switched || (on && (value & 2u) != 0)) {
      waiting_.clear();
      timed_out_ = false;
    }
  }
  void write_mcr(std::uint32_t value) {
    mcr_ = value & 0x1Fu;
    update_modem();
  }
  // Active modem inputs: CTS, DSR, RI, DCD from bit 0.
  void set_modem_pins(std::uint32_t pins) {
    pins_ = pins;
    update_modem();
  }

  // Receives a character from the line, or from the transmitter in loopback.
  void arrive(const Character& c) {
    if (waiting_.size() < (fifo_on() ? 16u : 1u)) {
      waiting_.push_back(c);
      if (waiting_.size() == 1) errors_ |= c.errors;
      return;
    }
    errors_ |= kOverrun;
    if (!fifo_on()) {
      waiting_.back() = c;
      errors_ |= c.errors;
    }
  }
  void four_characters_pass() { timed_out_ = timed_out_ || (fifo_on() && !waiting_.empty()); }

  // Writes to an idle transmitter, all before the first character has ended. Returns the characters that are sent.
  std::vector<std::uint32_t> transmit(const std::vector<std::uint32_t>& data) {
    thre_pending_ = thre_pending_ || !data.empty();
    std::vector<std::uint32_t> sent(data.begin(), data.begin() + std::min<std::ptrdiff_t>(std::ssize(data), 17));
    if (!fifo_on() && data.size() > 2) sent = {data.front(), data.back()};
    return sent;
  }

  std::uint32_t read_rbr() {
    timed_out_ = false;
    if (waiting_.empty()) return 0;
    const std::uint32_t data = waiting_.front().data;
    waiting_.pop_front();
    if (!waiting_.empty()) errors_ |= waiting_.front().errors;
    return data;
  }
  std::uint32_t read_lsr() {
    std::uint32_t value = 0x60u | errors_ | (waiting_.empty() ? 0u : 1u);
    bool bad = (errors_ & ~kOverrun) != 0;
    for (std::size_t i = 1; i < waiting_.size(); ++i) bad = bad || waiting_[i].errors != 0;
    if (bad && fifo_on()) value |= 0x80u;
    errors_ = 0;
    return value;
  }
  std::uint32_t read_msr() {
    const std::uint32_t value = lines_ << 4 | changes_;
    changes_ = 0;
    return value;
  }
  std::uint32_t read_iir() {
    const std::uint32_t id = source();
    if (id == 0x2) thre_pending_ = false;
    return id | (fifo_on() ? 0xC0u : 0u);
  }

  [[nodiscard]] std::uint32_t ier() const { return ier_; }
  [[nodiscard]] std::uint32_t fcr() const { return fcr_; }
  [[nodiscard]] std::uint32_t mcr() const { return mcr_; }
  [[nodiscard]] bool fifo_on() const { return (fcr_ & 1u) != 0; }
  [[nodiscard]] bool loops() const { return (mcr_ & 0x10u) != 0; }
  [[nodiscard]] bool irq() const { return source() != 0x1; }
  [[nodiscard]] std::size_t waiting() const { return waiting_.size(); }

 private:
  static constexpr std::uint32_t kOverrun = 2;

  [[nodiscard]] std::uint32_t source() const {
    static constexpr std::size_t kTriggers[] = {1, 4, 8, 14};
    const std::size_t trigger = fifo_on() ? kTriggers[fcr_ >> 6] : 1;
    if ((ier_ & 4u) != 0 && errors_ != 0) return 0x6;
    if ((ier_ & 1u) != 0 && waiting_.size() >= trigger) return 0x4;
    if ((ier_ & 1u) != 0 && timed_out_) return 0xC;
    if ((ier_ & 2u) != 0 && thre_pending_) return 0x2;
    if ((ier_ & 8u) != 0 && changes_ != 0) return 0x0;
    return 0x1;
  }

  void update_modem() {
    const std::uint32_t looped = (mcr_ >> 1 & 1u) | (mcr_ & 1u) << 1 | (mcr_ & 0xCu);
    const std::uint32_t next = loops() ? looped : pins_;
    const std::uint32_t ring = 4;
    changes_ |= (next ^ lines_) & ~ring;
    changes_ |= lines_ & ~next & ring;
    lines_ = next;
  }

  std::uint32_t ier_ = 0, fcr_ = 0, mcr_ = 0;
  std::uint32_t pins_ = 0, lines_ = 0, changes_ = 0;
  std::uint32_t errors_ = 0;  // OE, PE, FE and BI at their bits in LSR
  bool thre_pending_ = false, timed_out_ = false;
  std::deque<Character> waiting_;
};

}  // namespace armature::test
