// What the plant remembers while the edges of pulses and encoders are left out.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "cosim/plant/incremental_encoder.hpp"
#include "cosim/plant/mechanics.hpp"
#include "cosim/plant/servo_drive.hpp"
#include "cosim/plant/ticks/tick_steps.hpp"

namespace armature::cosim {

struct PlantTicks {
  // What a tick changes, as it was at its start.
  struct State {
    std::vector<ServoDrive::State> drives{};  // kAxes, or none yet
    Shafts shafts{};
    PerAxis<IncrementalEncoder::Motions> motions{};
    std::uint8_t moving = 0;
  };

  State begin{};
  TickSteps steps{};                       // of the latest tick
  bool first = true;                       // edges were computed before this tick
  PerAxis<Counts> counts{};                // after the edge before the one that raises the trigger pin at its end
  PerAxis<CountRange> quiet{};             // counts between which only a and b change; none: not known
  PerAxis<int> direction{};                // of the latest change of a count
  PerAxis<Cycles> changed_in{};            // the step in which it was, or may have been
  PerAxis<std::optional<Counts>> index{};  // the count at which the index came in this tick
};

}  // namespace armature::cosim
