// What the half periods in the registers of pulse_width make each axis emit, for the conservation checker.
//
// Independent of the controller: it follows finished bus writes and knows only the contract of rtl/pulse_width. A
// trigger takes the width that stands in the register, as often as it stands there. A write that finishes soon after a
// trigger may have been taken by it or not: both counts are allowed then.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"

namespace armature::cosim {

class PaperWidths {
 public:
  // `trigger_in_doubt`: the last trigger may have come after the effect of this write.
  void on_write(std::size_t axis, std::int32_t width, bool trigger_in_doubt);
  // A tick begins; the widths that may be active are those of the registers.
  void on_trigger();

  // Whether the axis may emit so many pulses in the present tick of this length.
  [[nodiscard]] bool allows(std::size_t axis, std::int32_t pulses, Cycles tick) const;
  // What it emits with the newest width that may be active.
  [[nodiscard]] std::int32_t expected(std::size_t axis, Cycles tick) const;

 private:
  PerAxis<std::int32_t> written_{};
  PerAxis<std::vector<std::int32_t>> active_ = make_per_axis([](std::size_t) { return std::vector<std::int32_t>{0}; });
};

}  // namespace armature::cosim
