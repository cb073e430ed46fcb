#include "cosim/serial/serial_script.hpp"

#include <algorithm>
#include <cmath>

#include "cosim/time/clock.hpp"

namespace armature::cosim {

std::vector<ScriptedItem> to_script(const std::vector<SerialSendSpec>& sends) {
  constexpr double kPpmPerPercent = 1e4;
  std::vector<ScriptedItem> script;
  for (const SerialSendSpec& send : sends) {
    ScriptedItem entry;
    entry.at = to_cycles(send.at_s);
    LineItem& item = entry.item;
    item.baud_error_ppm = static_cast<std::int32_t>(std::lround(send.baud_error_percent * kPpmPerPercent));
    item.wrong_parity = send.fault == SerialFault::kParity;
    item.no_stop = send.fault == SerialFault::kFraming;
    if (send.fault == SerialFault::kBreak) {
      item.kind = LineItem::Kind::kBreak;
      item.duration = to_cycles(send.break_s);
      script.push_back(entry);
    }
    for (const char byte : send.bytes) {
      item.data = static_cast<std::uint8_t>(byte);
      script.push_back(entry);
    }
  }
  std::ranges::stable_sort(script, {}, &ScriptedItem::at);
  return script;
}

}  // namespace armature::cosim
