// What a live page is told: once what does not change, and 60 times a second what does.
#pragma once

#include <optional>
#include <string>

#include "cosim/kernel/simulation_state.hpp"
#include "cosim/live/live_cell.hpp"
#include "cosim/live/live_kinematics.hpp"
#include "cosim/live/live_pendant.hpp"
#include "cosim/live/live_watch.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// The scenario, the arm with its limits and links, and the programs that the page can load at once:
// {"scenario", "description", "robot", "family", "arm", "meshes", "programs": [{"name", "text"}], "faults"}
[[nodiscard]] Json live_scenario(const Scenario& scenario);

struct LiveView {
  const Scenario& scenario;
  const LivePendant& pendant;
  const LiveWatch& watch;
  const LiveKinematics& kinematics;
  const LiveCell& cell;
  const std::string& program;  // that was sent last; empty: none
  SimulationState state;
  double factor = 0;  // simulated time per real time, lately
};

// Angles in degrees, lengths in mm, times in seconds. `joints_deg`, `tool`: as the encoders have them, `set_deg`: the
// set-points. The members `state`, `drives`, `alarm`, `system`, `program` and `messages` are what the pendant knows by
// its telemetry, everything else is seen in the simulation.
[[nodiscard]] Json live_state(const LiveView& view);

}  // namespace armature::cosim
