// A FIFO of the UART: 16 entries, or a single one that a push overwrites (the holding register of a 16450).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace armature::cosim::model {

template <class Entry>
class UartFifo {
 public:
  struct Orders {
    bool flush = false, push = false, pop = false;
    Entry entry{};  // with push
  };
  struct Events {
    bool overrun = false;  // an entry is lost: the new one of 16, or the old single one
    bool empties = false;
  };

  // What an edge with these orders will do.
  [[nodiscard]] Events events(const Orders& orders, bool single) const {
    const bool pops = orders.pop && level_ != 0;
    const bool full = single ? level_ != 0 : level_ == kDepth;
    return {.overrun = orders.push && full && !pops,
            .empties = level_ != 0 && (orders.flush || (pops && level_ == 1 && !orders.push))};
  }

  void edge(const Orders& orders, bool single) {
    const bool pops = orders.pop && level_ != 0;
    const bool overrun = events(orders, single).overrun;
    const bool replaces = overrun && single;
    const bool stores = orders.push && !overrun;
    if (replaces) entries_[first_] = orders.entry;
    if (stores) entries_[(first_ + level_) % kDepth] = orders.entry;
    if (orders.flush) {
      level_ = 0;
      fresh_ = false;
      return;
    }
    fresh_ = replaces || (pops ? level_ != 1 || orders.push : stores && level_ == 0);
    if (pops) first_ = (first_ + 1) % kDepth;
    level_ = level_ + (stores ? 1 : 0) - (pops ? 1 : 0);
  }

  [[nodiscard]] const Entry& oldest() const { return entries_[first_]; }
  [[nodiscard]] std::size_t level() const { return level_; }
  // The latest edge brought a new oldest entry.
  [[nodiscard]] bool is_fresh() const { return fresh_; }

 private:
  static constexpr std::size_t kDepth = 16;

  std::array<Entry, kDepth> entries_{};
  std::size_t first_ = 0, level_ = 0;
  bool fresh_ = false;
};

}  // namespace armature::cosim::model
