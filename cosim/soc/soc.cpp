#include "cosim/soc/soc.hpp"

namespace armature::cosim {

Soc::Progress Soc::access(const BusRequest& request, Cycles at, Cycles limit) {
  advance(at, StopOn::kAccess);
  start(request);
  return continue_access(limit);
}

Soc::Progress Soc::continue_access(Cycles limit) {
  const bool changed = advance(limit, StopOn::kPinChange);
  return {.response = pop_response(),
          .pins_changed = changed,
          .interrupts_fell = false,
          .ends = now(),
          .quiet_until = quiet_until()};
}

}  // namespace armature::cosim
