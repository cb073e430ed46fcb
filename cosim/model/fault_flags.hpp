// Sticky fault flags and the times of their events.
//
// A flag is set by its event and cleared by writing 1; an event at the edge of the clear wins. The time of a flag is
// that of the first event since it was last clear: the number of edges before the one that sets it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cosim/logic/axis_bits.hpp"
#include "cosim/model/block.hpp"

namespace armature::cosim::model {

template <std::size_t kFlags>
class FaultFlags {
 public:
  // `events`, `cleared`: bits of the flags at the edge `at`.
  void edge(Cycles at, std::uint32_t events, std::uint32_t cleared) {
    for_each_bit(events & ~flags_,
                 [&](std::size_t first) { times_[first] = static_cast<std::uint32_t>(at.value() - 1); });
    flags_ = (flags_ & ~cleared) | events;
  }

  [[nodiscard]] std::uint32_t flags() const { return flags_; }
  [[nodiscard]] std::uint32_t time(std::size_t flag) const { return times_[flag]; }

 private:
  std::uint32_t flags_ = 0;
  std::array<std::uint32_t, kFlags> times_{};
};

}  // namespace armature::cosim::model
