#include "cosim/logic/pin_table.hpp"

#include <algorithm>

#include "controller/base/axes.hpp"
#include "controller/regs/soc_map.hpp"
#include "cosim/logic/pin_list.hpp"

namespace armature::cosim {

static_assert(regs::soc::kNumAxes == kAxes, "the logic and the controller have the same number of axes");

std::span<const Pin> pins() {
  return kPins;
}

const Pin* find_pin(std::string_view name) {
  const auto found = std::ranges::find(kPins, name, &Pin::name);
  return found == std::end(kPins) ? nullptr : &*found;
}

}  // namespace armature::cosim
