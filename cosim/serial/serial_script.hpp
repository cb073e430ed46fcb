// The items that a scenario sends on the serial line.
#pragma once

#include <vector>

#include "controller/base/units.hpp"
#include "cosim/serial/line_sender.hpp"
#include "cosim/serial/serial_spec.hpp"

namespace armature::cosim {

struct ScriptedItem {
  Cycles at{};  // earliest start; later when the line is still busy
  LineItem item;
};

// Sorted by time; entries of the same time keep their order.
[[nodiscard]] std::vector<ScriptedItem> to_script(const std::vector<SerialSendSpec>& sends);

}  // namespace armature::cosim
