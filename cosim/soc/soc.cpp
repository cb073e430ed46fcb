#include "cosim/soc/soc.hpp"

namespace armature::cosim {

Soc::Progress Soc::access(const BusRequest& request, Cycles limit) {
  start(request);
  const bool changed = advance(limit, StopOn::kPinChange);
  return {.response = pop_response(), .pins_changed = changed};
}

}  // namespace armature::cosim
