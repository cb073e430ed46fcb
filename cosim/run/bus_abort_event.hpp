// An access that stopped a core, as the measurements keep it.
#pragma once

#include "cosim/kernel/signal.hpp"
#include "cosim/report/measure/run_events.hpp"

namespace armature::cosim {

[[nodiscard]] inline BusAbortEvent bus_abort_event(const BusAbort& abort, const RunPlace& place) {
  const BusRequest& request = abort.access.request;
  return {
      .core = abort.access.core, .write = request.write, .address = request.addr, .error = abort.error, .where = place};
}

}  // namespace armature::cosim
