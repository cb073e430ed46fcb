#include "cosim/soc/soc.hpp"

namespace armature::cosim {

Soc::Progress Soc::access(const BusRequest& request, Cycles limit) {
  start(request);
  return run_access(limit);
}

Soc::Progress Soc::run_access(Cycles limit) {
  const bool changed = advance(limit, StopOn::kPinChange);
  return {.response = pop_response(), .pins_changed = changed};
}

}  // namespace armature::cosim
