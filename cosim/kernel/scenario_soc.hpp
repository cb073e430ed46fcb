// The chip of a scenario.
#pragma once

#include <memory>

#include "cosim/scenario/scenario.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim {

// The chip with the logic and the engine that the scenario chooses, at cycle 0.
[[nodiscard]] std::unique_ptr<Soc> make_soc(const Scenario& scenario);

}  // namespace armature::cosim
