// Number of pulses that each axis emits with the half periods in the registers of pulse_width, for the conservation
// checker.
//
// It is independent of the controller: it uses finished bus writes and the specification of rtl/pulse_width. Each
// trigger activates the width that is in the register; the register keeps it until the next write. If a write finishes
// soon after a trigger, the trigger may have activated the old or the new width: both counts are allowed then.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"

namespace armature::cosim {

class PaperWidths {
 public:
  // `trigger_in_doubt`: the last trigger may have come after the effect of this write.
  void on_write(std::size_t axis, std::int32_t width, bool trigger_in_doubt);
  // A tick begins: only the widths in the registers may be active.
  void on_trigger();

  // Whether the axis may emit `pulses` in the present tick, which is `tick` cycles long.
  [[nodiscard]] bool allows(std::size_t axis, std::int32_t pulses, Cycles tick) const;
  // Number of pulses with the newest width of which `pulses` may be what a stop has left; none: no stop explains them.
  [[nodiscard]] std::optional<std::int32_t> whole_of(std::size_t axis, std::int32_t pulses, Cycles tick) const;
  // Number of pulses with the newest width that may be active.
  [[nodiscard]] std::int32_t expected(std::size_t axis, Cycles tick) const;

 private:
  PerAxis<std::int32_t> written_{};
  PerAxis<std::vector<std::int32_t>> active_ = make_per_axis([](std::size_t) { return std::vector<std::int32_t>{0}; });
};

}  // namespace armature::cosim
