#include "cosim/kernel/simulation_state.hpp"

#include <cstddef>

#include "cosim/kernel/simulation.hpp"

namespace armature::cosim {

SimulationState Simulation::look() {
  compute_edges();  // also those at now()
  if (!over_ && plant_.next_event() <= now()) advance_plant();
  SimulationState state{.now = now(),
                        .over = over_,
                        .triggers = triggers_,
                        .bus_reads = end_.bus_reads,
                        .bus_writes = end_.bus_writes,
                        .inputs = inputs(),
                        .outputs = soc_->outputs(),
                        .telemetry = row_.telemetry};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    state.drive_pulses[axis] = plant_.drive_pulses(axis);
    state.motor_counts[axis] = plant_.motor_counts(axis);
    state.motor_deg[axis] = plant_.motor_deg(axis, now());
    state.following_error_counts[axis] = plant_.following_error(axis);
  }
  return state;
}

}  // namespace armature::cosim
