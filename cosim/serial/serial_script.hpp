// What a scenario sends on the serial line, item by item.
#pragma once

#include <vector>

#include "controller/core/units.hpp"
#include "cosim/scenario/serial_spec.hpp"
#include "cosim/serial/line_sender.hpp"

namespace armature::cosim {

struct ScriptedItem {
  Cycles at{};  // not earlier; later when the line is still busy then
  LineItem item;
};

// In the order of their times, entries of the same time in their order.
[[nodiscard]] std::vector<ScriptedItem> to_script(const std::vector<SerialSendSpec>& sends);

}  // namespace armature::cosim
