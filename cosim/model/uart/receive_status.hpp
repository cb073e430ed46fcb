// The error bits of LSR and the time-out of the receive FIFO.
//
// PE, FE and BI of a character count from when it is the oldest one, OE at once. All stay until LSR is read. The
// time-out comes after four character times without a character that comes or is read.
#pragma once

#include <cstdint>

#include "cosim/model/block.hpp"
#include "cosim/model/uart/line_format.hpp"
#include "cosim/model/uart/receiver.hpp"
#include "cosim/model/uart/tick_clock.hpp"

namespace armature::cosim::model {

class ReceiveStatus {
 public:
  // At an edge.
  struct Orders {
    const ReceivedCharacter* arrives = nullptr;
    const ReceivedCharacter* fresh = nullptr;  // the oldest one, if the edge before made it that
    bool overrun = false, pop = false, flush = false, lsr_read = false;
    bool fifo_on = false, waiting = false;  // the FIFO is on, and not empty
    LineFormat format;
    std::int64_t divisor = 0;
    bool new_divisor = false;  // it was written at the edge before
  };

  // Bits of LSR.
  static constexpr std::uint32_t kOverrun = 1u << 1, kParity = 1u << 2, kFraming = 1u << 3, kBreak = 1u << 4;

  void edge(Cycles at, const Orders& orders) {
    const bool timing = orders.fifo_on && orders.waiting && !timeout_;
    if (timing) left_ -= clock_.pass(at, orders.divisor);
    const bool tick = timing && clock_.tick(at, orders.divisor);

    const bool bad_in = orders.arrives != nullptr && orders.arrives->is_bad() && !(orders.overrun && orders.fifo_on);
    const bool bad_out = orders.fresh != nullptr && orders.fresh->is_bad();
    errors_ = (orders.lsr_read ? 0u : errors(orders.fresh)) | (orders.overrun ? kOverrun : 0u);
    bad_behind_ = orders.flush ? 0 : bad_behind_ + (bad_in ? 1 : 0) - (bad_out ? 1 : 0);

    const bool restart = orders.fifo_on && (orders.arrives != nullptr || orders.pop);
    if (restart) {
      left_ = orders.format.timeout_ticks() - 1;
    } else if (tick) {
      timeout_ = timeout_ || left_ == 0;
      --left_;
    }
    if (orders.pop || orders.flush) timeout_ = false;
    if (restart || orders.new_divisor) clock_.restart(at, orders.divisor);
  }

  [[nodiscard]] Cycles wakes_at(bool fifo_on, bool waiting, std::int64_t divisor) const {
    return fifo_on && waiting && !timeout_ ? clock_.after(left_, divisor) : kNever;
  }

  // OE, PE, FE and BI as LSR shows them.
  [[nodiscard]] std::uint32_t errors(const ReceivedCharacter* fresh) const {
    if (fresh == nullptr) return errors_;
    return errors_ | (fresh->parity_error ? kParity : 0u) | (fresh->framing_error ? kFraming : 0u) |
           (fresh->is_break ? kBreak : 0u);
  }
  // An unread error, or one of a character behind the oldest.
  [[nodiscard]] bool has_fifo_error() const { return (errors_ & ~kOverrun) != 0 || bad_behind_ != 0; }
  [[nodiscard]] bool timeout() const { return timeout_; }

 private:
  std::uint32_t errors_ = 0;
  int bad_behind_ = 0;  // characters with errors that were not the oldest yet
  TickClock clock_;
  std::int64_t left_ = 0;  // ticks before the one of the time-out
  bool timeout_ = false;
};

}  // namespace armature::cosim::model
