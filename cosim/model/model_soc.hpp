// A Soc whose logic is the model, computed from event to event.
//
// An access that nothing disturbs takes one computed edge (quick_access.hpp). From a stop of the clock during an
// access, and from a block that hangs, the handshakes of the bus are computed clock for clock.
#pragma once

#include <memory>

#include "cosim/bus/bus_spec.hpp"
#include "cosim/logic/logic_spec.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim::model {

// A chip at cycle 0. `seed` is for the random stalls of `bus`.
[[nodiscard]] std::unique_ptr<Soc> make_model_soc(Variant variant, const BusSpec& bus, std::uint64_t seed);

}  // namespace armature::cosim::model
